// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "core/faults/chance.hpp"
#include "core/faults/schedule.hpp"

namespace arcbid {

/// A Gilbert-Elliott chain (Gilbert 1960, Elliott 1963) whose state at message n is a function of
/// the chance and n alone, however n was reached. Every step has a hashed draw, and a draw that
/// leads both states to the same one forgets the past; so the state is found by looking back to
/// the latest such draw (coupling from the past, Propp and Wilson 1996), and is stationary exactly.
class BurstChain {
 public:
  /// mean_length >= odds of the bad state, as the reader demands; shorter ones are not possible.
  BurstChain(const Burst& burst, const Chance& chance);

  bool is_bad(std::uint64_t sequence);
  bool loses(std::uint64_t sequence);

 private:
  struct Known {
    std::uint64_t sequence;
    bool bad;
  };
  std::optional<bool> state_from_draw(std::uint64_t sequence) const;

  Chance chance_;
  double good_loss_, bad_loss_;
  double bad_share_;    ///< stationary probability of the bad state
  double good_to_bad_;  ///< probability of a step from good to bad
  double bad_to_bad_;   ///< probability of a step from bad to bad
  std::optional<Known> last_;
};

}  // namespace arcbid
