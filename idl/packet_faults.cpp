// SPDX-License-Identifier: GPL-3.0-or-later
#include "idl/packet_faults.hpp"

#include "idl/rtps_packet.hpp"

namespace arcbid {

void PacketFaults::install(const FaultSchedule& schedule, const std::vector<Uav>& fleet,
                           AgentId self, TimeNs epoch_ns) {
  const std::scoped_lock lock(mutex_);
  links_.clear();
  for (const Uav& uav : fleet)
    if (uav.id != self) links_.emplace(uav.id, LinkModel(schedule, fleet, uav.id, self));
  epoch_ns_ = epoch_ns;
}

std::vector<TimeNs> PacketFaults::arrivals_ns(std::span<const std::uint8_t> packet,
                                              TimeNs now_ns) {
  const auto prefix = sender_of(packet);
  const auto sender = prefix ? agent_of(*prefix) : std::nullopt;
  if (!sender || is_discovery(packet)) return {now_ns};
  const std::scoped_lock lock(mutex_);
  const auto link = links_.find(*sender);
  if (link == links_.end()) return {now_ns};
  const std::uint64_t number = link->second.counters().sent + 1;
  Fate fate = link->second.send(number, packet.size(), now_ns - epoch_ns_);
  for (TimeNs& at_ns : fate.arrivals_ns) at_ns += epoch_ns_;
  return fate.arrivals_ns;
}

std::map<AgentId, LinkCounters> PacketFaults::counters() const {
  const std::scoped_lock lock(mutex_);
  std::map<AgentId, LinkCounters> out;
  for (const auto& [sender, link] : links_) out.emplace(sender, link.counters());
  return out;
}

}  // namespace arcbid
