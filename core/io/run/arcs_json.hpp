// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/arcs/mission.hpp"
#include "core/auction/no_bidders.hpp"

namespace arcbid {

/// 64-bit digests and lives in JSON, whose readers often have only doubles.
std::string hex(std::uint64_t value);

/// As docs/RUN_DIRECTORY.md has them. Numbers are exact: they read back to the same bits.
nlohmann::json fleet_json(const Mission& mission);
nlohmann::json arcs_json(const Mission& mission);
nlohmann::json no_bidders_json(const std::vector<NoBidder>& left);
/// [x, y, z, look x, look y, look z]
nlohmann::json waypoint_json(const Waypoint& waypoint);

}  // namespace arcbid
