// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/base/ids.hpp"
#include "core/io/faults/fields.hpp"

namespace arcbid::yaml {

/// No time of a schedule is further off.
inline constexpr double longest_s = 86400;

/// A time in seconds, kept in nanoseconds.
Kind<TimeNs> seconds(double low, double high);
/// The end of a window; absent when there is none.
Kind<TimeNs> end_seconds();
/// A whole number that is positive and at most 2^53.
Kind<std::uint64_t> byte_count();

/// An agent's id.
Kind<AgentId> agent_id();
/// An agent's id, or `coordinator` (agent 0).
Kind<AgentId> agent_or_coordinator();
/// `any` (an empty list), an id, or a list of distinct ids.
Kind<std::vector<AgentId>> agent_ids();

}  // namespace arcbid::yaml
