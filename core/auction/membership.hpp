// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/auction/message.hpp"

namespace arcbid {

/// Who was heard of when. Heartbeat counters travel inside every status message and are passed on,
/// so an agent that only others can hear still counts as alive.
class Membership {
 public:
  Membership(std::size_t members, std::size_t self, TimeNs now);

  /// Somebody heard this heartbeat of `member`; news only if it is later than what was known.
  void heard(std::size_t member, const Heartbeat& beat, TimeNs now);
  /// Everybody's silence is counted from `now` on: nobody is late before the start.
  void restart_leases(TimeNs now);
  bool silent(std::size_t member, TimeNs now, TimeNs lease_ns) const;
  /// When `member` would fall silent.
  TimeNs deadline(std::size_t member, TimeNs lease_ns) const;

  const std::vector<Heartbeat>& heartbeats() const { return heartbeats_; }

 private:
  std::size_t self_;
  std::vector<Heartbeat> heartbeats_;
  std::vector<TimeNs> heard_ns_;
};

}  // namespace arcbid
