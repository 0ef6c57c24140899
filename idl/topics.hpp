// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ArcBidPubSubTypes.h>

#include "core/arcs/mission.hpp"
#include "core/auction/message.hpp"

namespace arcbid {

/// How a topic's samples are delivered; docs/WIRE.md has the table and the reasons.
enum class Delivery {
  latched,   ///< RELIABLE, TRANSIENT_LOCAL, asynchronous: late joiners get the newest, of any size
  bids,      ///< BEST_EFFORT, or RELIABLE and TRANSIENT_LOCAL by NetworkConfig::reliable_bids
  periodic,  ///< BEST_EFFORT: the next one comes soon
};

/// A kind of message, its topic, and the generated type that carries it. The name's version is
/// wire::SCHEMA_VERSION, so that fleets of different versions don't even match.
template <class Message>
struct Topic;

template <>
struct Topic<Mission> {
  using Type = wire::MissionPubSubType;
  static constexpr const char* name = "arcbid/v6/mission";
  static constexpr Delivery delivery = Delivery::latched;
};
template <>
struct Topic<ControlMessage> {
  using Type = wire::ControlPubSubType;
  static constexpr const char* name = "arcbid/v6/control";
  static constexpr Delivery delivery = Delivery::latched;
};
template <>
struct Topic<BidMessage> {
  using Type = wire::BidsPubSubType;
  static constexpr const char* name = "arcbid/v6/bids";
  static constexpr Delivery delivery = Delivery::bids;
};
template <>
struct Topic<RelayMessage> {
  using Type = wire::RelayPubSubType;
  static constexpr const char* name = "arcbid/v6/relays";
  static constexpr Delivery delivery = Delivery::bids;
};
template <>
struct Topic<StatusMessage> {
  using Type = wire::StatusPubSubType;
  static constexpr const char* name = "arcbid/v6/status";
  static constexpr Delivery delivery = Delivery::periodic;
};
template <>
struct Topic<RouteMessage> {
  using Type = wire::RoutePubSubType;
  static constexpr const char* name = "arcbid/v6/routes";
  static constexpr Delivery delivery = Delivery::latched;
};

}  // namespace arcbid
