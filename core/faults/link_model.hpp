// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/arcs/mission.hpp"
#include "core/faults/burst_chain.hpp"
#include "core/faults/chance.hpp"
#include "core/faults/schedule.hpp"

namespace arcbid {

/// Why a message did not arrive.
enum class DropReason : std::uint8_t { none, no_link, cut, loss, burst, reach, queue };

/// What happens to one message.
struct Fate {
  std::vector<TimeNs> arrivals_ns;  ///< when each copy arrives; empty: dropped
  DropReason reason = DropReason::none;
};

/// What happened on one directed link so far. `delayed`: arrived later than it was sent.
struct LinkCounters {
  std::uint64_t sent = 0, dropped = 0, delayed = 0, duplicated = 0, bytes = 0;
  friend bool operator==(const LinkCounters&, const LinkCounters&) = default;
};

/// One directed link under a schedule. Chance is a hash of the schedule's seed, the link and the
/// message's sequence number: neither timing nor other links have a say. Windows go by time, and
/// queues by what was sent before.
class LinkModel {
 public:
  /// `fleet`: ascending ids, with the agents' places (homes). `from` and `to` must be in it.
  LinkModel(const FaultSchedule& schedule, const std::vector<Uav>& fleet, AgentId from, AgentId to);

  /// The fate of message `sequence` (growing within a life of the sender; `bytes` long), sent at
  /// `now_ns`. Bursts advance with the sequence number, over gaps too.
  Fate send(std::uint64_t sequence, std::uint64_t bytes, TimeNs now_ns);

  const LinkCounters& counters() const { return counters_; }

 private:
  /// A fault of the schedule on this link, and what it has come to.
  struct Effect {
    LinkFault fault;  ///< its window ends with the schedule's faults
    Chance chance;
    double reach_loss;  ///< by the agents' distance
    bool in_shadow;     ///< an obstacle is in the line of sight
    std::optional<BurstChain> burst;
    TimeNs busy_until_ns = 0;  ///< when what was sent so far has left a link of limited capacity
  };
  struct Cut {
    Window when;
    TimeNs flap_ns;
  };

  DropReason lost(std::uint64_t sequence, std::uint64_t bytes, TimeNs now_ns);
  bool is_cut(TimeNs now_ns) const;
  std::optional<TimeNs> through_queues(std::uint64_t bytes, TimeNs now_ns);
  TimeNs arrival_ns(std::uint64_t sequence, std::uint64_t copy, TimeNs sent_ns,
                    TimeNs due_ns) const;
  std::vector<TimeNs> arrivals_ns(std::uint64_t sequence, TimeNs sent_ns, TimeNs due_ns) const;
  Fate dropped(DropReason reason);

  bool linked_;
  std::vector<Effect> effects_;
  std::vector<Cut> cuts_;
  LinkCounters counters_;
};

/// Whether the topology has the link at all; nobody has one to itself.
bool linked(const Topology& topology, const std::vector<Uav>& fleet, AgentId from, AgentId to);

/// What an agent's own clock shows at `now_ns`, under the clock faults of the schedule.
TimeNs clock_of(const FaultSchedule& schedule, AgentId agent, TimeNs now_ns);

}  // namespace arcbid
