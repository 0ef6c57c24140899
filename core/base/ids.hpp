// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <cstdint>

namespace arcbid {

/// A number that names one thing. Agents, tasks and arcs are distinct types, so that one cannot be
/// passed for another. "No agent" is an empty optional, never a special value.
template <class Tag>
struct Id {
  std::uint32_t value = 0;
  friend constexpr auto operator<=>(Id, Id) = default;
};

using AgentId = Id<struct AgentTag>;  ///< i, k, m, n: an agent (UAV); ids start at 1.
using TaskId = Id<struct TaskTag>;    ///< j: a work piece, its position in the task set.
using ArcId = Id<struct ArcTag>;      ///< a published arc, its position in the arc set.

/// Time as it comes in with events, in nanoseconds since an epoch the caller chooses.
using TimeNs = std::int64_t;

}  // namespace arcbid
