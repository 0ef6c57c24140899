// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/auction/message.hpp"
#include "core/faults/schedule.hpp"

namespace arcbid {

/// The agent's statement, spoilt. Were it not refused it would be applied: it is newer than all
/// that the agent has said. Not for over_bid and replay.
BidMessage malformed(const BidMessage& sound, Malformation how, std::size_t tasks);

/// Bids far above anybody's for every task: well formed, and false.
BidMessage over_bid(const BidMessage& sound, std::size_t tasks);

}  // namespace arcbid
