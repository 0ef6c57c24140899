// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/arcs/mission.hpp"
#include "core/auction/score.hpp"
#include "core/auction/task_set.hpp"

namespace arcbid {

enum class NoBidderReason : std::uint8_t { payload, endurance, endurance_left, bundle_limit };
inline constexpr std::array<std::string_view, 4> no_bidder_reason_names{
    "payload", "endurance", "endurance-left", "bundle-limit"};
constexpr std::string_view name_of(NoBidderReason why) {
  return no_bidder_reason_names[static_cast<std::size_t>(why)];
}

/// A stretch of an arc that nobody takes, and why not. Metres along the arc, seconds.
struct NoBidder {
  ArcId arc;
  double from_m = 0, to_m = 0;
  NoBidderReason why = NoBidderReason::payload;
  Payload needs = Payload::any;  ///< what it must be flown with
  /// Of those that could fly it but for their endurance, the one that lacks least, the lower id on
  /// ties; what it would need, home to home, with all that it won where that comes first; and its
  /// endurance. None: no endurance is the reason, or paths are not known.
  std::optional<AgentId> nearest;
  double needed_s = 0, endurance_s = 0;
  std::uint32_t limit = 0;  ///< tasks that one may take, where that is the reason
  friend bool operator==(const NoBidder&, const NoBidder&) = default;
};

/// "no bidder: needs 1240.0 s, best endurance 900.0 s (agent 3)".
std::string reason(const NoBidder& left);
/// The same, after which stretch of which arc it is.
std::string to_text(const NoBidder& left);

/// One of those who bid, and what it won.
struct Winnings {
  Uav uav;
  std::vector<TaskId> taken;                                 ///< in any order
  std::optional<std::vector<PathStop>> path = std::nullopt;  ///< p_i; none: not known
};

/// The path of who took `taken` in that order.
std::vector<PathStop> path_of(const std::vector<TaskId>& taken, const TaskSet& set, const Uav& uav,
                              const AuctionSettings& settings, const Transit& transit);

/// All that none of `members` won, arc by arc; pieces beside each other that nobody takes for the
/// same reason are one. A pure function, so that all who agree say the same. The reasons, first
/// that holds: nobody carries the payload; nobody of these could fly it alone; all of these have as
/// many tasks as they may take; nobody of these has enough endurance left. How much is left to whom
/// is said where all paths are known.
std::vector<NoBidder> no_bidders(const std::vector<Winnings>& members, const TaskSet& set,
                                 const AuctionSettings& settings, const Transit& transit);

}  // namespace arcbid
