// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "idl/bus.hpp"

namespace arcbid {

/// One bus for all the agents of a process. To each it is as a bus of its own: what one of them
/// says reaches the others of the process at once, and everybody else over DDS. It must outlive
/// them.
class SharedBus {
 public:
  /// `agents`: those of this process, ascending. See Bus for the rest.
  SharedBus(const NetworkConfig& network, std::uint32_t domain, const std::vector<AgentId>& agents,
            std::uint32_t fleet_size, FaultTier tier);

  void publish(AgentId from, const BidMessage& message) { tell(from, message); }
  void publish(AgentId from, const RelayMessage& message) { tell(from, message); }
  void publish(AgentId from, const StatusMessage& message) { tell(from, message); }
  void publish(AgentId from, const RouteMessage& message);

  /// What has arrived for `agent` since it was last asked, in order of arrival.
  std::vector<Received> take(AgentId agent);
  /// Waits up to `timeout` for something to arrive for anybody.
  void wait(std::chrono::nanoseconds timeout);
  /// Makes a wait() in progress return at once. Safe from any thread.
  void wake() { bus_.wake(); }

  /// See Bus. Packets are one process's: only for an agent that has one of its own.
  void set_packet_faults(const FaultSchedule& schedule, const std::vector<Uav>& fleet,
                         TimeNs epoch_ns) {
    bus_.set_packet_faults(schedule, fleet, epoch_ns);
  }
  std::map<AgentId, LinkCounters> packet_counters() const { return bus_.packet_counters(); }

  /// Agents other than one of this process's that can be reached in both directions.
  std::uint32_t matched_agents() const;
  /// What `agent` sent and received. What DDS dropped is told of the first agent only, for nobody
  /// knows whom it was for.
  TrafficCounters counters(AgentId agent) const;

 private:
  struct Member {
    std::vector<Received> inbox;
    std::uint64_t sent = 0, received = 0, bytes_sent = 0;
  };
  template <class Message>
  void tell(AgentId from, const Message& message);
  template <class Message>
  void send(AgentId from, const Message& message);
  void deliver(Received received);

  Bus bus_;
  std::map<AgentId, Member> members_;
};

}  // namespace arcbid
