// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/arcs/mission.hpp"
#include "core/auction/message.hpp"
#include "core/auction/score.hpp"
#include "core/auction/task_set.hpp"
#include "core/tour/tour.hpp"

namespace arcbid {

/// What a UAV flies, home to home, and what each stage of planning gave. Metres, seconds.
struct Route {
  std::vector<RouteLeg> legs;  ///< each begins where the one before ended; empty: stay at home
  double length_m = 0;         ///< transits and arcs, after local search
  double time_s = 0;           ///< at the UAV's speed
  std::size_t pieces = 0;      ///< arcs and parts of arcs after combining
  double auction_order_m = 0;  ///< the tour in the order of the auction's path, directions exact
  double crsom_m = 0;          ///< the tour in CRSOM's order, directions exact
};

/// Combines the pieces won (eq. 11), orders them by CRSOM, chooses directions exactly, and improves
/// that tour and the one the auction priced the bids with; never longer than either. `path`: p_i at
/// agreement.
Route plan_route(const Mission& mission, const TaskSet& tasks, const std::vector<PathStop>& path,
                 const Uav& uav, const Transit& transit, const StillWanted& wanted = {});

}  // namespace arcbid
