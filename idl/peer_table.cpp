// SPDX-License-Identifier: GPL-3.0-or-later
#include "idl/peer_table.hpp"

#include <set>
#include <utility>

namespace arcbid {

void PeerTable::set_agents(const Prefix& peer, std::vector<std::string> agents) {
  const std::scoped_lock lock(mutex_);
  peers_[peer].agents = std::move(agents);
  erase_if_blank(peer);
}

void PeerTable::writer_matched(const Prefix& peer, std::int32_t change) {
  const std::scoped_lock lock(mutex_);
  peers_[peer].writers += change;
  erase_if_blank(peer);
}

void PeerTable::reader_matched(const Prefix& peer, std::int32_t change) {
  const std::scoped_lock lock(mutex_);
  peers_[peer].readers += change;
  erase_if_blank(peer);
}

void PeerTable::erase_if_blank(const Prefix& peer) {
  const auto at = peers_.find(peer);
  if (at->second == Peer{}) peers_.erase(at);
}

std::uint32_t PeerTable::matched_agents() const {
  const std::scoped_lock lock(mutex_);
  std::set<std::string> agents;
  for (const auto& [prefix, peer] : peers_)
    if (peer.writers > 0 && peer.readers > 0) agents.insert(peer.agents.begin(), peer.agents.end());
  return static_cast<std::uint32_t>(agents.size());
}

}  // namespace arcbid
