// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/auction/message.hpp"

namespace arcbid {

/// Bytes of a message as CDR (idl/ArcBid.idl), without what RTPS puts in front. The simulator does
/// not know the wire; a test holds these against the generated code.
std::uint64_t wire_size(const BidMessage& message);
std::uint64_t wire_size(const RelayMessage& message);
std::uint64_t wire_size(const StatusMessage& message);

}  // namespace arcbid
