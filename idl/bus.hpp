// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/arcs/mission.hpp"
#include "core/auction/message.hpp"
#include "core/faults/link_model.hpp"
#include "core/faults/schedule.hpp"
#include "core/faults/tier.hpp"
#include "core/io/config.hpp"

namespace arcbid {

/// A sample that was refused at the edge: wrong schema version, NaN, broken enumeration, exception
/// in the decoder. Counted and reported, never applied, never fatal.
struct Malformed {
  std::string topic;
  std::string reason;
};

using Received = std::variant<Mission, ControlMessage, BidMessage, RelayMessage, StatusMessage,
                              RouteMessage, Malformed>;

struct TrafficCounters {
  std::uint64_t sent = 0, received = 0;  ///< messages
  std::uint64_t dropped = 0;     ///< malformed, not accepted by DDS, or no room in the inbox
  std::uint64_t bytes_sent = 0;  ///< serialised payload, counted once however many receive it
};

/// Who takes part: an agent, several that share a process (ascending ids), or the coordinator.
struct BusMember {
  std::vector<AgentId> agents;  ///< none: the coordinator
  BusMember(AgentId one) : agents{one} {}
  BusMember(std::vector<AgentId> several) : agents(std::move(several)) {}
  BusMember(std::nullopt_t) {}
};
inline constexpr std::nullopt_t the_coordinator = std::nullopt;

/// The DDS side of a process: one participant, a topic a kind of message (docs/WIRE.md). All Fast
/// DDS types stay behind this class. publish() and wait() are called from one thread; reception
/// happens on DDS threads and waits in a queue. An agent's own samples are not delivered to itself.
///
/// An agent reads missions, control, bids, relays and status, and writes bids, relays, status and
/// routes. The coordinator reads status and routes, and writes missions and control; publishing
/// what this member doesn't write is a bug in the caller and aborts.
class Bus {
 public:
  /// `domain`: 0..231. `member`: who shares the bus. `fleet_size`: how many agents to expect (sizes
  /// the range of ports where peers are looked for). `tier`: packets puts a layer under DDS on
  /// which set_packet_faults() acts. Throws InputError when the network settings can't be used: not
  /// an IPv4 address, no such interface, no such domain, or no port left in it.
  Bus(const NetworkConfig& network, std::uint32_t domain, const BusMember& member,
      std::uint32_t fleet_size, FaultTier tier = FaultTier::messages);
  ~Bus();

  void publish(const Mission& mission);
  void publish(const ControlMessage& message);
  void publish(const BidMessage& message);
  void publish(const RelayMessage& message);
  void publish(const StatusMessage& message);
  void publish(const RouteMessage& message);

  /// What has arrived, in order of arrival; waits up to `timeout` for the first.
  std::vector<Received> wait(std::chrono::nanoseconds timeout);

  /// Makes a wait() in progress return at once. Safe from any thread.
  void wake();

  /// Other agents, by name, that are matched in both directions: on the bid topic; for the
  /// coordinator, their status writer and their mission reader. One that leaves is gone at once,
  /// one that is killed after DDS's lease of 10 s.
  std::uint32_t matched_agents() const;

  TrafficCounters counters() const;

  /// From now on the schedule acts on RTPS packets that arrive here from other agents of `fleet`
  /// (ascending ids, with their places), discovery aside; until then all pass. `epoch_ns`: the
  /// launch, on the monotonic clock. Only an agent's bus of tier packets can: otherwise this is a
  /// bug in the caller.
  void set_packet_faults(const FaultSchedule& schedule, const std::vector<Uav>& fleet,
                         TimeNs epoch_ns);
  /// What it has done so far, by sender, in packets. Empty without packet faults.
  std::map<AgentId, LinkCounters> packet_counters() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace arcbid
