// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/auction/view.hpp"
#include "sim/replay/order.hpp"

namespace arcbid {

/// What a run looked like at any moment, by what its logs say. Nothing is decided again: beliefs
/// follow from the statements that an agent had accepted until then.
class Playback {
 public:
  explicit Playback(const RunArchive& run);

  const std::vector<Moment>& moments() const { return moments_; }  ///< in causal order
  /// How many moments are not later than `t_ns`.
  std::size_t at(TimeNs t_ns) const;

  enum class State : std::uint8_t { unborn, waiting, bidding, agreed, routed, dead, ended };
  struct AgentState {
    State state = State::unborn;
    std::optional<std::size_t> life;  ///< the newest begun, in RunArchive::lives
    std::size_t steps = 0;            ///< of that life
    std::uint32_t round = 0;
  };
  /// By fleet position, after the first `moments` moments.
  std::vector<AgentState> agents(std::size_t moments) const;

  /// z_i and y_i of a life after its first `steps` steps: an entry for each task.
  std::vector<Belief> beliefs(std::size_t life, std::size_t steps) const;
  /// V of a life after so many steps.
  View view(std::size_t life, std::size_t steps) const;
  /// Who owns what when everybody is believed about itself: of the statements that the living had
  /// made about themselves, the best. With tables, what the lowest-numbered living agent believes.
  std::vector<Belief> owners(std::size_t moments) const;

 private:
  struct Turn {
    std::size_t moment = 0;  // from here on
    AgentState state;
  };
  void note(std::size_t moment);
  Statement statement(std::size_t life, std::size_t member, const Learnt& learnt) const;
  Statement on_record(std::size_t life, std::size_t member, const Learnt& learnt) const;
  std::optional<Learnt> newest(std::size_t life, std::size_t member, std::size_t steps) const;

  const RunArchive& run_;
  std::vector<Moment> moments_;
  std::vector<std::vector<Turn>> turns_;        // by fleet position: when its state changed
  std::vector<std::size_t> position_;           // in the fleet, by life
  std::vector<std::vector<std::size_t>> when_;  // by life, then step: its moment
};

}  // namespace arcbid
