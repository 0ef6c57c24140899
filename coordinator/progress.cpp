// SPDX-License-Identifier: GPL-3.0-or-later
#include "coordinator/progress.hpp"

namespace arcbid {

Progress::Progress(const Mission& mission) : lease_ns_(mission.auction.lease_ns) {
  for (const Uav& uav : mission.fleet) roster_.push_back(uav.id);
}

void Progress::heard(const StatusMessage& status, TimeNs now_ns) {
  if (status.phase == Phase::waiting_for_mission) {
    mission_wanted_ = true;
    return;
  }
  const auto known = status_.find(status.header.sender);
  const auto stamp = [](const Header& h) { return std::pair(h.incarnation, h.sequence); };
  if (known != status_.end() && stamp(status.header) <= stamp(known->second.header)) return;
  status_[status.header.sender] = status;
  heard_ns_[status.header.sender] = now_ns;
}

void Progress::heard(const RouteMessage& route) {
  routed_[route.header.sender] = {route.view_hash, route.owners_digest};
}

bool Progress::complete_under(const StatusMessage& witness, TimeNs now_ns) const {
  if (witness.phase != Phase::routed || witness.view.size() != roster_.size()) return false;
  for (std::size_t k = 0; k < roster_.size(); ++k) {
    if (witness.view[k].key.dead) {
      const auto heard = heard_ns_.find(roster_[k]);
      if (heard != heard_ns_.end() && now_ns - heard->second < lease_ns_) return false;
      continue;
    }
    const auto status = status_.find(roster_[k]);
    const auto route = routed_.find(roster_[k]);
    if (status == status_.end() || route == routed_.end()) return false;
    if (status->second.phase != Phase::routed || status->second.view_hash != witness.view_hash ||
        route->second.view_hash != witness.view_hash)
      return false;
  }
  return true;
}

std::optional<std::pair<AgentId, AgentId>> Progress::discord() const {
  for (const auto& [one, a] : routed_)
    for (const auto& [other, b] : routed_)
      if (a.view_hash == b.view_hash && a.owners_digest != b.owners_digest)
        return std::pair(one, other);
  return std::nullopt;
}

std::optional<std::uint64_t> Progress::complete(TimeNs now_ns) const {
  for (const auto& [agent, status] : status_)
    if (complete_under(status, now_ns)) return status.view_hash;
  return std::nullopt;
}

}  // namespace arcbid
