// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/faults/schedule.hpp"
#include "core/io/faults/kinds.hpp"

namespace arcbid::yaml {

// The keys of a fault file, a table for each mapping in it. Reading, printing and the reference are
// all made from them.

const Keys<FaultSchedule>& schedule_keys();
const Keys<Topology>& topology_keys();
const Keys<Partition>& partition_keys();

const Keys<LinkFault>& link_keys();
const Keys<Burst>& burst_keys();
const Keys<Delay>& delay_keys();
const Keys<Capacity>& capacity_keys();
const Keys<Reach>& reach_keys();
const Keys<Obstacle>& obstacle_keys();

/// One way in which an agent fails: the word for it, and the keys below that word.
struct AgentFaultKey {
  AgentFaultKind kind;
  std::string name, meaning;
  Keys<AgentFault> keys;
};
const std::vector<AgentFaultKey>& agent_fault_keys();
Kind<AgentFault> agent_fault();

/// Reports values that are legal one by one but do not go together, and agents that are not in the
/// fleet (unless that is empty).
void check_together(const FaultSchedule& schedule, const std::vector<AgentId>& fleet,
                    Report& report);

}  // namespace arcbid::yaml
