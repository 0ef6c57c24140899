// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/auction/membership.hpp"

#include <algorithm>
#include <limits>

namespace arcbid {

Membership::Membership(std::size_t members, std::size_t self, TimeNs now)
    : self_(self), heartbeats_(members), heard_ns_(members, now) {}

void Membership::heard(std::size_t member, const Heartbeat& beat, TimeNs now) {
  if (beat <= heartbeats_[member]) return;
  heartbeats_[member] = beat;
  heard_ns_[member] = now;
}

void Membership::restart_leases(TimeNs now) {
  std::fill(heard_ns_.begin(), heard_ns_.end(), now);
}

bool Membership::silent(std::size_t member, TimeNs now, TimeNs lease_ns) const {
  return member != self_ && now - heard_ns_[member] > lease_ns;
}

TimeNs Membership::deadline(std::size_t member, TimeNs lease_ns) const {
  if (member == self_) return std::numeric_limits<TimeNs>::max();
  return heard_ns_[member] + lease_ns + 1;
}

}  // namespace arcbid
