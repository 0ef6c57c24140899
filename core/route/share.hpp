// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/arcs/mission.hpp"
#include "core/auction/agent.hpp"
#include "core/auction/task_set.hpp"
#include "core/route/exchanged.hpp"

namespace arcbid {

/// What everybody flies after an agreement and the exchanges that follow it. A pure function of the
/// mission and of what was agreed on, which is the same for all members.
struct FleetShare {
  std::vector<AgentId> members;              ///< of the agreement, ascending
  std::vector<std::vector<PathStop>> paths;  ///< by member; empty where nothing is exchanged
  std::uint64_t exchanges = 0;               ///< tried out on the way, also if undone later
  bool is_better() const { return !paths.empty(); }  ///< than what was won; else that is flown
};

/// With exchanges this takes up to seconds (docs/TRADES.md).
FleetShare fleet_share(const Mission& mission, const TaskSet& set, const Agreement& agreement,
                       const Transit& transit, const StillWanted& wanted = {});

/// The same as one member sees it.
struct Share {
  std::vector<std::optional<AgentId>> owners;  ///< by task; none: nobody flies it
  std::vector<PathStop> path;                  ///< its own, before its tour is improved
  std::uint64_t exchanges = 0;
};
Share share_of(const Mission& mission, const TaskSet& set, const Agreement& agreement, AgentId self,
               const Transit& transit, const StillWanted& wanted = {});

/// The same for everybody who comes to the same owners.
std::uint64_t digest(const std::vector<std::optional<AgentId>>& owners);

}  // namespace arcbid
