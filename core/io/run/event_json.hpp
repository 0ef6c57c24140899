// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/arcs/mission.hpp"
#include "core/auction/agent.hpp"

namespace arcbid {

/// JSON of what the core consumes and produces. Numbers are exact: doubles print so that they read
/// back to the same bits; 64-bit digests and lives are hexadecimal strings, for JSON readers that
/// have only doubles.
std::string hex(std::uint64_t value);
nlohmann::json to_json(const Mission& mission);
nlohmann::json to_json(const Statement& statement);
nlohmann::json to_json(const Event& event);
nlohmann::json to_json(const DecisionMade& decision);
nlohmann::json to_json(const Agreement& agreement);
nlohmann::json to_json(const BidMessage& message);
nlohmann::json to_json(const RelayMessage& message);
nlohmann::json to_json(const StatusMessage& message);
nlohmann::json to_json(const Vec3& point);
/// [x, y, z, look x, look y, look z]
nlohmann::json to_json(const Waypoint& waypoint);
/// "tick", "bid", "relay", "status" or "route_published"
std::string_view kind(const Event& event);

}  // namespace arcbid
