// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/io/config.hpp"

namespace arcbid {

/// A mission made from a config, and what its owner should know about it.
struct MissionPlan {
  Mission mission;
  std::vector<std::string> warnings;  ///< one line each
  Structure shown;  ///< the structure for whoever looks: thinned to at most 200,000 points
};

/// Structure in, arcs out, a home for every UAV: reads the structure (or generates the parametric
/// one), makes its arcs and the model of what is in the way between them, places the fleet. `id`:
/// distinct for every mission. Throws InputError.
MissionPlan plan_mission(const Config& config, std::uint64_t id);

/// UAVs without a home of their own stand on the ground along the structure's longer side, evenly
/// spread and `clear_m` away from it (`low_m`, `high_m`: its bounding box): short ways out, and
/// less to bid about.
std::vector<Uav> place_fleet(const FleetConfig& fleet, const Vec3& low_m, const Vec3& high_m,
                             double clear_m);

}  // namespace arcbid
