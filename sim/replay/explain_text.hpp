// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "sim/replay/explain.hpp"

namespace arcbid {

/// What lies behind an explanation.
struct Reason {
  enum class Cause : std::uint8_t { none, earlier_lost, came_free, death };
  std::string rule{};
  std::optional<double> bid_before{};  ///< of a bid: what it bid until then
  Cause cause = Cause::none;           ///< of a release
  TaskId other{};                      ///< the task that was lost or came free
  std::size_t place = 0;               ///< its place in the bundle, from 1
  std::optional<AgentId> by{};         ///< who took it, or had it
  std::optional<Source> source{};
};

/// In words, without the time and the agent.
std::string text_of(const Explanation& told, const Reason& reason);

}  // namespace arcbid
