// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "core/arcs/mission.hpp"
#include "core/base/error.hpp"
#include "core/base/ids.hpp"

namespace arcbid {

/// The ids of a mission's fleet, which ascend.
inline std::vector<AgentId> roster_of(const Mission& mission) {
  std::vector<AgentId> roster;
  for (const Uav& uav : mission.fleet) roster.push_back(uav.id);
  return roster;
}

/// The UAV of that id, which is of the mission's fleet.
inline const Uav& uav_of(const Mission& mission, AgentId agent) {
  const auto at = std::find_if(mission.fleet.begin(), mission.fleet.end(),
                               [agent](const Uav& uav) { return uav.id == agent; });
  check(at != mission.fleet.end(), "an agent is of its mission's fleet");
  return *at;
}

/// Where an agent stands in a roster of ascending ids.
inline std::optional<std::size_t> position_in(const std::vector<AgentId>& roster, AgentId agent) {
  if (roster.empty()) return std::nullopt;
  // Where ids have no gaps, as they mostly have, this is it.
  const std::size_t guess = agent.value - roster.front().value;
  if (guess < roster.size() && roster[guess] == agent) return guess;
  const auto at = std::lower_bound(roster.begin(), roster.end(), agent);
  if (at == roster.end() || *at != agent) return std::nullopt;
  return static_cast<std::size_t>(at - roster.begin());
}

}  // namespace arcbid
