// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <boost/random/mersenne_twister.hpp>
#include <cstdint>
#include <vector>

#include "core/tour/cycle.hpp"
#include "core/tour/neighbours.hpp"

namespace arcbid {

/// Shortens a tour by sequential exchanges of two or three legs along neighbour lists (Or-opt,
/// Or-3opt and 2-opt are among them, segments turned or not), and goes on by disturbing it: a
/// double bridge, repaired where it was made, and as a rule taken back where the tour is longer for
/// it (iterated local search; Martin, Otto, Felten 1991; Johnson, McGeoch 1997). Same arguments,
/// same tours.
class LocalSearch {
 public:
  /// `entries` as of Cycle. Both references must outlive this.
  LocalSearch(const TourCosts& costs, const Neighbours& neighbours,
              std::vector<std::uint32_t> entries, std::uint64_t seed);

  /// One disturbance, repaired. Time does not grow with the tour but for the legs' places in it.
  void disturb();

  /// The best tour so far: the first node of each arc, and what its legs cost. At first the local
  /// optimum next to the tour given.
  const std::vector<std::uint32_t>& best() const { return best_; }
  double best_cost() const { return best_cost_; }

 private:
  using Gaps = std::array<std::uint32_t, 4>;

  void settle();
  bool improve(std::uint32_t node);
  bool extend(double gain);
  bool close(double gain);
  bool takes_part(std::uint32_t node) const;
  void enqueue(std::uint32_t node);
  Gaps stretch_gaps();
  bool walk_gaps(Gaps& gaps);
  void bridge(const Gaps& gaps);
  bool is_welcome();
  std::uint32_t below(std::uint32_t limit);

  const TourCosts& costs_;
  const Neighbours& neighbours_;
  Cycle cycle_;
  boost::random::mt19937_64 random_;
  Exchange exchange_;                 // being built
  std::vector<std::uint32_t> queue_;  // of nodes that may gain; a ring
  std::size_t queue_begin_ = 0, queued_ = 0;
  std::vector<std::uint8_t> is_queued_;
  double gained_ = 0;  // since the last disturbance
  double cost_ = 0, best_cost_ = 0;
  std::vector<std::uint32_t> best_;
};

}  // namespace arcbid
