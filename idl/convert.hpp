// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ArcBid.h>

#include <cstdint>
#include <string>
#include <variant>

#include "core/arcs/mission.hpp"
#include "core/auction/message.hpp"

namespace arcbid {

/// Core's value, or why the sample was refused.
template <class T>
using Decoded = std::variant<T, std::string>;

/// A sample whose payload the generated decoder refused arrives with this schema version.
inline constexpr std::uint32_t kUndecodable = 0;

/// Limits on what is accepted from the wire: far above every real mission, far below what would
/// exhaust a machine.
inline constexpr std::size_t kMaxText = 4096;            ///< characters of a name or a reason
inline constexpr std::size_t kMaxAgents = 1024;          ///< roster, ready set, view
inline constexpr std::size_t kMaxArcs = 200'000;         ///< also tasks, claims, legs
inline constexpr std::size_t kMaxWaypoints = 4'000'000;  ///< all arcs of a mission, or all legs

/// Core to wire and back is the identity, bit for bit. to_wire trusts its caller; from_wire trusts
/// nothing: it refuses a foreign schema version, NaN and infinity in any field, values outside an
/// enumeration, and sizes beyond the limits above. Neither throws (but for std::bad_alloc).
wire::Mission to_wire(const Mission& mission);
wire::Control to_wire(const ControlMessage& message);
wire::Bids to_wire(const BidMessage& message);
wire::Relay to_wire(const RelayMessage& message);
wire::Status to_wire(const StatusMessage& message);
wire::Route to_wire(const RouteMessage& message);

/// Further checks: at least one arc and one UAV; arcs of at least two waypoints, consecutive ones
/// distinct; UAV ids ascending from 1; positive speeds, discount, piece length, tick and lease.
Decoded<Mission> from_wire(const wire::Mission& mission);
Decoded<ControlMessage> from_wire(const wire::Control& message);
Decoded<BidMessage> from_wire(const wire::Bids& message);
Decoded<RelayMessage> from_wire(const wire::Relay& message);
Decoded<StatusMessage> from_wire(const wire::Status& message);
Decoded<RouteMessage> from_wire(const wire::Route& message);

}  // namespace arcbid
