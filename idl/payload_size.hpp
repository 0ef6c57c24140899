// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/auction/message.hpp"

namespace arcbid {

/// Bytes of a message on the wire: its serialised payload, without RTPS's own headers.
std::uint64_t payload_size(const BidMessage& message);
std::uint64_t payload_size(const RelayMessage& message);
std::uint64_t payload_size(const StatusMessage& message);

}  // namespace arcbid
