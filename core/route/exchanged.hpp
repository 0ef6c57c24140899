// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/arcs/mission.hpp"
#include "core/auction/score.hpp"
#include "core/auction/task_set.hpp"
#include "core/tour/tour.hpp"
#include "core/trades/exchanges.hpp"

namespace arcbid {

/// Paths of a whole fleet, by its members, and what it took to get there.
struct FleetPaths {
  std::vector<std::vector<PathStop>> paths;
  std::uint64_t exchanges = 0;  ///< tried out on the way, also if undone later
  bool is_better = false;       ///< else they are what was won
};

/// What the fleet flies after it exchanged what it won (core/trades), as `mission.auction.trades`
/// says. Tasks are exchanged in lots: arcs, or parts of them where an arc is long beside what one
/// UAV does. A lot that was won by several begins with who won most of it. The slowest UAV is
/// faster than by `won` and everybody keeps its limits (endurance, payload, bundle_limit), or it is
/// `won`; a task flown in `won` is flown by one UAV, once, and no other task is. `won` is by
/// `members`, which are of the mission's fleet: those who are left of it.
FleetPaths exchanged(const Mission& mission, const std::vector<Uav>& members, const TaskSet& set,
                     std::vector<std::vector<PathStop>> won, const Transit& transit,
                     const StillWanted& wanted = {});

}  // namespace arcbid
