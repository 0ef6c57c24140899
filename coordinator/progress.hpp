// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "core/arcs/mission.hpp"
#include "core/auction/message.hpp"

namespace arcbid {

/// How far the fleet is, from what the agents say of themselves. Pure bookkeeping.
class Progress {
 public:
  explicit Progress(const Mission& mission);

  void heard(const StatusMessage& status, TimeNs now_ns);
  void heard(const RouteMessage& route);

  /// The view hash under which every living member has proven agreement and published its route;
  /// none: not yet, or some member was declared dead that was heard since, and will be back.
  std::optional<std::uint64_t> complete(TimeNs now_ns) const;
  /// Two that agreed and yet came to different exchanges: their arithmetic differs, which waiting
  /// does not mend.
  std::optional<std::pair<AgentId, AgentId>> discord() const;
  /// Somebody still waits for the mission.
  bool mission_wanted() const { return mission_wanted_; }
  void mission_sent() { mission_wanted_ = false; }

 private:
  bool complete_under(const StatusMessage& witness, TimeNs now_ns) const;

  TimeNs lease_ns_;
  std::vector<AgentId> roster_;
  std::map<AgentId, StatusMessage> status_;
  std::map<AgentId, TimeNs> heard_ns_;
  struct Routed {
    std::uint64_t view_hash = 0, owners_digest = 0;
  };
  std::map<AgentId, Routed> routed_;  // by its newest route
  bool mission_wanted_ = false;
};

}  // namespace arcbid
