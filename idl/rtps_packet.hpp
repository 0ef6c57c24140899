// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "idl/guid_prefix.hpp"

namespace arcbid {

/// What can be read off an RTPS packet, a datagram's payload, without decoding what it carries
/// (DDSI-RTPS 2.2, sections 8.3.3 and 9.4.5). Any bytes are legal.

/// The sender's prefix; none: this is no RTPS packet.
std::optional<GuidPrefix> sender_of(std::span<const std::uint8_t> packet);

/// Whether an RTPS packet belongs to discovery: some submessage of it that carries data or speaks
/// about data (DATA, HEARTBEAT, ACKNACK, GAP and those of fragments) is of a built-in entity. What
/// is cut short before such a submessage shows is not.
bool is_discovery(std::span<const std::uint8_t> packet);

}  // namespace arcbid
