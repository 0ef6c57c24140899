// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>

namespace arcbid {

/// What the faults of links act on: the auction's messages, above DDS, or RTPS packets, under it.
enum class FaultTier : std::uint8_t { messages, packets };

/// As it stands on command lines and in result files.
constexpr std::string_view name_of(FaultTier tier) {
  return tier == FaultTier::packets ? "packets" : "messages";
}

}  // namespace arcbid
