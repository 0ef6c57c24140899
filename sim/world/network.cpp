// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/world/network.hpp"

#include <algorithm>
#include <utility>

#include "core/base/digest.hpp"
#include "sim/world/wire_size.hpp"

namespace arcbid {
namespace {

bool is_twinned(const FaultSchedule& faults, AgentId agent) {
  return std::any_of(faults.agents.begin(), faults.agents.end(), [agent](const AgentFault& fault) {
    return fault.agent == agent && fault.kind == AgentFaultKind::twin;
  });
}

}  // namespace

Network::Network(const WorldSpec& spec)
    : size_(spec.mission.fleet.size()),
      seed_(spec.seed),
      latency_ns_(spec.latency_ns),
      faults_end_ns_(spec.faults.until_ns.value_or(INT64_MAX)),
      calm_ns_(arcbid::calm_ns(spec)) {
  const std::vector<Uav>& fleet = spec.mission.fleet;
  const bool faulty = !spec.faults.links.empty() || !spec.faults.partitions.empty();
  if (!faulty) faults_end_ns_ = 0;
  for (const Uav& from : fleet)
    for (const Uav& to : fleet) {
      if (from.id == to.id) has_twin_.push_back(is_twinned(spec.faults, from.id));
      linked_.push_back(linked(spec.faults.topology, fleet, from.id, to.id));
      if (faulty) links_.emplace_back(spec.faults, fleet, from.id, to.id);
    }
}

template <class Message>
void Network::broadcast(std::size_t from, std::uint32_t life, const Message& message, TimeNs now_ns,
                        bool is_malformed) {
  ++messages_;
  const std::uint64_t bytes = wire_size(message), sequence = message.header.sequence;
  Delivery delivery;
  delivery.from = from;
  delivery.from_life = life;
  delivery.is_malformed = is_malformed;
  delivery.event = std::make_shared<Event>(Event{now_ns, message});
  for (delivery.to = 0; delivery.to < size_; ++delivery.to) {
    if (delivery.to == from && has_twin_[from])
      arrive(delivery, now_ns, sequence, now_ns);  // its twin stands next to it
    else if (has_link(from, delivery.to))
      send(delivery, sequence, bytes, now_ns);
    else if (delivery.to != from && watch_)
      watch_(delivery, {{}, DropReason::no_link});
  }
}

void Network::send(const Delivery& message, std::uint64_t sequence, std::uint64_t bytes,
                   TimeNs now_ns) {
  bytes_ += bytes;
  if (now_ns >= faults_end_ns_) {
    arrive(message, now_ns, sequence, now_ns);
    return;
  }
  LinkModel& link = links_[message.from * size_ + message.to];
  const Fate fate = link.send(sequence, bytes, now_ns);
  if (watch_) watch_(message, fate);
  for (const TimeNs at_ns : fate.arrivals_ns) arrive(message, at_ns, sequence, now_ns);
}

void Network::arrive(Delivery message, TimeNs at_ns, std::uint64_t sequence, TimeNs now_ns) {
  const std::uint64_t draw =
      Digest::mix(seed_ ^ Digest::mix(sequence ^ Digest::mix(message.from * size_ + message.to)) ^
                  static_cast<std::uint64_t>(at_ns));
  const auto spread = static_cast<std::uint64_t>(latency_ns_.most - latency_ns_.least + 1);
  message.at_ns = at_ns + latency_ns_.least + static_cast<TimeNs>(draw % spread);
  message.order = order_++;
  if (now_ns < calm_ns_) last_arrival_ns_ = std::max(last_arrival_ns_, message.at_ns);
  queue_.push(std::move(message));
}

Delivery Network::pop() {
  Delivery next = queue_.top();
  queue_.pop();
  return next;
}

template void Network::broadcast(std::size_t, std::uint32_t, const BidMessage&, TimeNs, bool);
template void Network::broadcast(std::size_t, std::uint32_t, const RelayMessage&, TimeNs, bool);
template void Network::broadcast(std::size_t, std::uint32_t, const StatusMessage&, TimeNs, bool);

}  // namespace arcbid
