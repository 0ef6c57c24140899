// SPDX-License-Identifier: GPL-3.0-or-later
#include "agent/shared_bus.hpp"

#include <algorithm>
#include <utility>

namespace arcbid {
SharedBus::SharedBus(const NetworkConfig& network, std::uint32_t domain,
                     const std::vector<AgentId>& agents, std::uint32_t fleet_size, FaultTier tier)
    : bus_(network, domain, agents, fleet_size, tier) {
  for (const AgentId agent : agents) members_[agent];
}

template <class Message>
void SharedBus::send(AgentId from, const Message& message) {
  const TrafficCounters before = bus_.counters();
  bus_.publish(message);
  const TrafficCounters after = bus_.counters();
  Member& sender = members_.at(from);
  sender.sent += after.sent - before.sent;
  sender.bytes_sent += after.bytes_sent - before.bytes_sent;
}

template <class Message>
void SharedBus::tell(AgentId from, const Message& message) {
  send(from, message);
  for (auto& [agent, member] : members_)
    if (agent != from) {
      member.inbox.emplace_back(message);
      ++member.received;
    }
}

template void SharedBus::tell(AgentId, const BidMessage&);
template void SharedBus::tell(AgentId, const RelayMessage&);
template void SharedBus::tell(AgentId, const StatusMessage&);

void SharedBus::publish(AgentId from, const RouteMessage& message) {
  send(from, message);
}

/// To all of this process. What was refused at the edge is told of the first one only.
void SharedBus::deliver(Received received) {
  for (auto& [agent, member] : members_) {
    ++member.received;
    member.inbox.push_back(received);
    if (std::holds_alternative<Malformed>(received)) return;
  }
}

void SharedBus::wait(std::chrono::nanoseconds timeout) {
  const bool waiting = std::any_of(members_.begin(), members_.end(),
                                   [](const auto& m) { return !m.second.inbox.empty(); });
  for (Received& received : bus_.wait(waiting ? std::chrono::nanoseconds(0) : timeout))
    deliver(std::move(received));
}

std::vector<Received> SharedBus::take(AgentId agent) {
  return std::exchange(members_.at(agent).inbox, {});
}

std::uint32_t SharedBus::matched_agents() const {
  return bus_.matched_agents() + static_cast<std::uint32_t>(members_.size()) - 1;
}

TrafficCounters SharedBus::counters(AgentId agent) const {
  const Member& member = members_.at(agent);
  const bool first = agent == members_.begin()->first;
  return {member.sent, member.received, first ? bus_.counters().dropped : 0, member.bytes_sent};
}

}  // namespace arcbid
