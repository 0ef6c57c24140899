// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/auction/message.hpp"
#include "core/faults/schedule.hpp"

namespace arcbid {

/// What an agent says beside its auction under the `malformed` faults of a schedule. From its time
/// on, and once the agent has stated something that can be spoilt, each fault says one message a
/// tick until it has said its `count`. `over_bid` says all of them at once, and nothing follows.
class Malformer {
 public:
  /// `tasks`: how many the mission has. `tick_ns`: the auction's.
  Malformer(const FaultSchedule& schedule, AgentId self, std::size_t tasks, TimeNs tick_ns);

  /// The agent stated this.
  void said(const BidMessage& bid);

  struct Message {
    Malformation how = Malformation::nan_bid;
    BidMessage message;
  };
  struct Speech {
    std::vector<Message> messages;
    bool ends = false;  ///< the agent's process must end now
  };
  /// What is to be said at `now_ns`, since launch.
  Speech due(TimeNs now_ns);
  /// When there will be something to say next; none: not before the agent states something, or
  /// never.
  std::optional<TimeNs> next_ns() const;

 private:
  struct Fault {
    TimeNs next_ns = 0;
    Malformation how = Malformation::nan_bid;
    std::uint32_t left = 0;
  };
  BidMessage spoilt(const Fault& fault) const;
  void bid_over(const Fault& fault, Speech& speech) const;

  std::size_t tasks_;
  TimeNs tick_ns_;
  std::vector<Fault> faults_;  // with messages left to say
  std::optional<BidMessage> said_;
  std::vector<BidMessage> history_;  // the first ones, to be replayed
};

}  // namespace arcbid
