// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "core/arcs/mission.hpp"
#include "core/auction/message.hpp"
#include "core/auction/view.hpp"

namespace arcbid {

/// What a message must fit: this mission, these tasks, this roster, this policy, this limit.
struct Expected {
  std::uint64_t mission_digest = 0;
  std::uint64_t task_digest = 0;
  std::size_t tasks = 0;
  AgentId self;
  PolicyKind policy = PolicyKind::claims;
  std::uint32_t bundle_limit = 0;  ///< L_t; 0: none
};

/// The latest life that another agent may speak of: milliseconds until the year 2109. Beyond it a
/// life could not be refuted by a later one for ever.
inline constexpr std::uint64_t last_incarnation = (std::uint64_t{1} << 42) - 1;

/// The latest time in a table of ACBBA: logical clocks must have room to go on.
inline constexpr std::uint64_t last_timestamp = UINT64_MAX - 1 - (std::uint64_t{1} << 32);

/// Why a message is refused, in one line; none: it is sound (but its bids: bid_audit.hpp). Nothing
/// refused is ever applied.
std::optional<std::string> refusal(const Header& header, const Expected& expected,
                                   const View& view);
std::optional<std::string> refusal(const Statement& statement, const Expected& expected,
                                   const View& view);
std::optional<std::string> refusal(const StatusMessage& status, const View& view);

}  // namespace arcbid
