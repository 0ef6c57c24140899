// SPDX-License-Identifier: GPL-3.0-or-later
#include "agent/faulty_links.hpp"

namespace arcbid {

FaultyLinks::FaultyLinks(FaultSchedule schedule, const std::vector<Uav>& fleet, AgentId self) {
  for (const Uav& uav : fleet)
    if (uav.id != self) links_.emplace(uav.id, LinkModel(schedule, fleet, uav.id, self));
}

std::vector<TimeNs> FaultyLinks::arrived(AgentMessage message, std::uint64_t bytes, TimeNs now_ns) {
  const Header& header =
      std::visit([](const auto& m) -> const Header& { return m.header; }, message);
  const auto link = links_.find(header.sender);
  std::vector<TimeNs> arrivals_ns{now_ns};
  if (link != links_.end())
    arrivals_ns = link->second.send(header.sequence, bytes, now_ns).arrivals_ns;
  for (const TimeNs at_ns : arrivals_ns) waiting_.emplace(std::pair(at_ns, arrivals_++), message);
  return arrivals_ns;
}

std::vector<AgentMessage> FaultyLinks::due(TimeNs now_ns) {
  std::vector<AgentMessage> out;
  while (!waiting_.empty() && waiting_.begin()->first.first <= now_ns) {
    out.push_back(std::move(waiting_.begin()->second));
    waiting_.erase(waiting_.begin());
  }
  return out;
}

std::optional<TimeNs> FaultyLinks::next_ns() const {
  if (waiting_.empty()) return std::nullopt;
  return waiting_.begin()->first.first;
}

std::map<AgentId, LinkCounters> FaultyLinks::counters() const {
  std::map<AgentId, LinkCounters> out;
  for (const auto& [sender, link] : links_) out.emplace(sender, link.counters());
  return out;
}

}  // namespace arcbid
