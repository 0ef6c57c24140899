// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "core/arcs/mission.hpp"
#include "core/auction/message.hpp"
#include "core/faults/link_model.hpp"

namespace arcbid {

using AgentMessage = std::variant<BidMessage, RelayMessage, StatusMessage>;

/// The links to one agent under a fault schedule, between the bus and the auction: what comes out
/// of DDS goes in, what the auction may hear comes out, then or later. One LinkModel for each
/// sender, so that the same message of the same sender always meets the same fate.
class FaultyLinks {
 public:
  FaultyLinks(FaultSchedule schedule, const std::vector<Uav>& fleet, AgentId self);

  /// A message of `bytes` on the wire came out of DDS. One of somebody who is not of the fleet
  /// passes: to refuse it is the auction's business. Returns when each copy of it will be heard,
  /// ascending; none: it is lost.
  std::vector<TimeNs> arrived(AgentMessage message, std::uint64_t bytes, TimeNs now_ns);
  /// What is due by now, in the order in which it is due.
  std::vector<AgentMessage> due(TimeNs now_ns);
  /// When something will be due next.
  std::optional<TimeNs> next_ns() const;

  std::map<AgentId, LinkCounters> counters() const;

 private:
  std::map<AgentId, LinkModel> links_;                                // by sender
  std::map<std::pair<TimeNs, std::uint64_t>, AgentMessage> waiting_;  // by due time, then arrival
  std::uint64_t arrivals_ = 0;
};

}  // namespace arcbid
