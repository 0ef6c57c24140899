// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/airspace/obstacle_transit.hpp"
#include "core/arcs/mission.hpp"

namespace arcbid {

/// The transit that everybody who has the mission makes alike, bit for bit: around its obstacles,
/// with all lengths between homes and tasks' end points known, or straight where it names none.
/// Throws InputError for an airspace that no coordinator makes.
std::shared_ptr<const Transit> make_transit(const Mission& mission);

/// The same, where the mission has an airspace: `table` is what ObstacleTransit::table() was of the
/// same mission's transit; empty: it is worked out.
std::shared_ptr<const ObstacleTransit> make_obstacle_transit(const Mission& mission,
                                                             std::vector<double> table = {});

}  // namespace arcbid
