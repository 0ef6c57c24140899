// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "core/base/ids.hpp"

namespace arcbid {

/// What the GUIDs of a participant and of all that is its own begin with, and what the header of
/// every RTPS packet that it sends says (DDSI-RTPS 2.2, sections 8.2.4 and 9.4.4).
using GuidPrefix = std::array<std::uint8_t, 12>;

/// A prefix that no other participant has, not even an earlier life of the same one, and that says
/// which agent sends (none: the coordinator):
///
///     01 0f | host | host, process, time and a count, hashed | role | agent id
///     0       2      4                                         9      10
///
/// `host_address`: of the interface in use; it and the host's name tell hosts apart. Ids that do
/// not fit (above 65535) are a bug in the caller.
GuidPrefix new_guid_prefix(std::optional<AgentId> agent, const std::string& host_address);

/// The agent that a prefix names; none: the coordinator's, or not one of ours.
std::optional<AgentId> agent_of(const GuidPrefix& prefix);

}  // namespace arcbid
