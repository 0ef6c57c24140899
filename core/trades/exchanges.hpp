// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>

#include "core/arcs/mission.hpp"
#include "core/trades/allocation.hpp"

namespace arcbid {

/// What a fleet makes of an allocation by exchanges between two of it at a time: lots handed over
/// or swapped, what is flown from some point on exchanged, and everybody's own order improved. A
/// pure function of what it is given, bit for bit: whoever knows the same allocation comes to the
/// same result by itself, and nothing has to be sent. How much is tried depends on the numbers of
/// lots and traders, never on a clock. Work is done in steps of some ms, so that a caller can do
/// something in between.
class Exchanges {
 public:
  /// Every lot must stand in `start`, once. `transit` must outlive this.
  Exchanges(std::vector<Trader> traders, std::vector<Lot> lots, Allocation start,
            const Transit& transit, TradesKind kind, std::uint64_t seed);
  ~Exchanges();

  bool done() const;
  void step();

  /// The best so far: its slowest trader is faster than that of `start`, and everybody keeps its
  /// limits; or it is `start`.
  const Allocation& best() const;
  /// Exchanges of two traders that were tried out and kept for a while, also if undone later.
  std::uint64_t count() const;

 private:
  struct Search;
  std::unique_ptr<Search> search_;
};

/// All steps at once.
Allocation exchanged(std::vector<Trader> traders, std::vector<Lot> lots, Allocation start,
                     const Transit& transit, TradesKind kind, std::uint64_t seed);

}  // namespace arcbid
