// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/auction/score.hpp"
#include "sim/auction/rounds.hpp"

namespace arcbid {

/// What was sent in one round.
struct Traffic {
  std::uint64_t messages = 0, sends = 0, bytes = 0;
  std::uint64_t difference_bytes = 0;  ///< the same where links lose nothing: only what is new
  std::uint64_t order_bytes = 0;       ///< and without bids (claims, where it is asked for)
};

/// How one family of policies behaves in synchronous rounds.
class RoundsProtocol {
 public:
  virtual ~RoundsProtocol() = default;
  /// All decide, then all hear their neighbours. Returns whether anybody's mind changed.
  virtual bool play(Traffic& traffic) = 0;
  /// Whether every agent has proof that this is final. Policies without a proof never say so.
  virtual bool proven() const { return false; }
  virtual bool agreed() const = 0;
  virtual std::vector<std::vector<PathStop>> paths() const = 0;
};

struct RoundsWorld {
  const Instance& instance;
  const AuctionSettings& settings;
  const Transit& transit;
  std::vector<std::vector<std::size_t>> neighbours;
  Encoding encoding = Encoding::bids;

  std::size_t agents() const { return instance.fleet.size(); }
  std::size_t tasks() const { return instance.tasks.tasks.size(); }
  std::vector<AgentId> roster() const;
};

std::unique_ptr<RoundsProtocol> cbba_rounds(const RoundsWorld& world);
std::unique_ptr<RoundsProtocol> acbba_rounds(const RoundsWorld& world);
std::unique_ptr<RoundsProtocol> claims_rounds(const RoundsWorld& world);

/// Sizes of what travels, without padding, as fixed by the figures that others are compared with.
inline constexpr std::uint64_t message_bytes = 16, statement_bytes = 12, claim_bytes = 10,
                               timestamp_bytes = 4, changed_belief_bytes = 12,
                               timed_belief_bytes = 14, hash_bytes = 8;

}  // namespace arcbid
