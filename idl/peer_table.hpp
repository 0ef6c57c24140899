// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <fastdds/rtps/common/GuidPrefix_t.hpp>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace arcbid {

/// Which participants are agents, and how many of their endpoints match ours on the two topics that
/// count. Fed by DDS threads in any order (a participant may go before its endpoints do, and come
/// back under the same prefix), read by the owner of the bus.
class PeerTable {
 public:
  using Prefix = eprosima::fastrtps::rtps::GuidPrefix_t;

  /// `agents`: the ids of those that share the participant; none: not an agent's, or one that left.
  void set_agents(const Prefix& peer, std::vector<std::string> agents);
  /// `change` is +1 or -1: an endpoint of the peer's came or went.
  void writer_matched(const Prefix& peer, std::int32_t change);
  void reader_matched(const Prefix& peer, std::int32_t change);

  /// Agents with at least one matched writer and one matched reader. An agent that was killed and
  /// started again counts once while DDS still believes in its old life.
  std::uint32_t matched_agents() const;

 private:
  struct Peer {
    std::vector<std::string> agents;
    std::int32_t writers = 0, readers = 0;
    friend bool operator==(const Peer&, const Peer&) = default;
  };
  void erase_if_blank(const Prefix& peer);
  mutable std::mutex mutex_;
  std::map<Prefix, Peer> peers_;
};

}  // namespace arcbid
