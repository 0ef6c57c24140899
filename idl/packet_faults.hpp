// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <span>
#include <vector>

#include "core/arcs/mission.hpp"
#include "core/faults/link_model.hpp"
#include "core/faults/schedule.hpp"

namespace arcbid {

/// The links to one agent under a fault schedule, below DDS: decides the fate of each RTPS packet
/// that arrives. One LinkModel for each sending agent; a packet's sequence number is its place
/// among the packets of that agent that arrived here. Safe from any thread. Times are of the
/// monotonic clock.
class PacketFaults {
 public:
  /// Until this is called all packets pass. `epoch_ns`: the launch, from which the schedule counts.
  void install(const FaultSchedule& schedule, const std::vector<Uav>& fleet, AgentId self,
               TimeNs epoch_ns);

  /// When DDS is to see the packet that arrives now, ascending, once for each copy; empty: never.
  /// Discovery passes, and so does what is not RTPS or not from another agent of the fleet.
  std::vector<TimeNs> arrivals_ns(std::span<const std::uint8_t> packet, TimeNs now_ns);

  /// By sender; empty before install().
  std::map<AgentId, LinkCounters> counters() const;

 private:
  mutable std::mutex mutex_;
  std::map<AgentId, LinkModel> links_;  // by sender
  TimeNs epoch_ns_ = 0;
};

}  // namespace arcbid
