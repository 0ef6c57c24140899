// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <bit>

#include "core/arcs/mission.hpp"
#include "core/auction/message.hpp"

/// Equality bit for bit: -0.0 and 0.0 differ.
namespace arcbid {

inline bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
inline bool same(const Vec3& a, const Vec3& b) {
  return same(a.x(), b.x()) && same(a.y(), b.y()) && same(a.z(), b.z());
}
inline bool same(const Waypoint& a, const Waypoint& b) {
  return same(a.position_m, b.position_m) && same(a.look, b.look);
}
template <class T>
bool same(const std::vector<T>& a, const std::vector<T>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const T& x, const T& y) { return same(x, y); });
}
inline bool same(const Arc& a, const Arc& b) {
  return a.id == b.id && a.kind == b.kind && same(a.waypoints, b.waypoints) &&
         a.payload == b.payload;
}
inline bool same(const Uav& a, const Uav& b) {
  return a.id == b.id && same(a.home_m, b.home_m) && same(a.speed_mps, b.speed_mps) &&
         a.endurance_s == b.endurance_s && a.payload == b.payload;
}
inline bool same(const AuctionSettings& a, const AuctionSettings& b) {
  return a.policy == b.policy && a.score == b.score && same(a.discount_per_s, b.discount_per_s) &&
         a.split_m == b.split_m && a.max_tasks == b.max_tasks && a.bundle_limit == b.bundle_limit &&
         a.trades == b.trades && a.audit_bids == b.audit_bids && a.tick_ns == b.tick_ns &&
         a.lease_ns == b.lease_ns && a.barrier_ns == b.barrier_ns;
}
inline bool same(const AccessPoint& a, const AccessPoint& b) {
  return same(a.position_m, b.position_m);
}
inline bool same(const Access& a, const Access& b) {
  return a.arc == b.arc && a.waypoint == b.waypoint && same(a.points, b.points);
}
inline bool same(const Airspace& a, const Airspace& b) {
  return same(a.low_m, b.low_m) && same(a.cell_m, b.cell_m) && a.cells == b.cells &&
         a.runs == b.runs && same(a.accesses, b.accesses);
}
inline bool same(const Mission& a, const Mission& b) {
  return a.id == b.id && a.name == b.name && same(a.arcs, b.arcs) && same(a.fleet, b.fleet) &&
         same(a.airspace, b.airspace) && same(a.auction, b.auction) && a.tour.seed == b.tour.seed &&
         a.tour.epochs == b.tour.epochs && a.tour.solver == b.tour.solver &&
         a.tour.iterations == b.tour.iterations;
}
inline bool same(const ControlMessage& a, const ControlMessage& b) {
  return a.mission_digest == b.mission_digest && a.command == b.command && a.reason == b.reason;
}
inline bool same(const Header& a, const Header& b) {
  return a.sender == b.sender && a.incarnation == b.incarnation && a.sequence == b.sequence &&
         a.mission_digest == b.mission_digest && a.task_digest == b.task_digest;
}
inline bool same(const Claim& a, const Claim& b) {
  return a.task == b.task && same(a.bid, b.bid);
}
inline bool same(const Belief& a, const Belief& b) {
  return a.winner == b.winner && same(a.bid, b.bid);
}
inline bool same(const Claims& a, const Claims& b) {
  return same(a.bundle, b.bundle);
}
inline bool same(const Table& a, const Table& b) {
  return same(a.beliefs, b.beliefs) && a.timestamps == b.timestamps;
}
inline bool same(const Statement& a, const Statement& b) {
  if (a.agent != b.agent || a.key != b.key || a.body.index() != b.body.index()) return false;
  if (const auto* claims = std::get_if<Claims>(&a.body))
    return same(*claims, std::get<Claims>(b.body));
  return same(std::get<Table>(a.body), std::get<Table>(b.body));
}
inline bool same(const BidMessage& a, const BidMessage& b) {
  return same(a.header, b.header) && same(a.statement, b.statement);
}
inline bool same(const RelayMessage& a, const RelayMessage& b) {
  return same(a.header, b.header) && same(a.statement, b.statement);
}
inline bool same(const StatusMessage& a, const StatusMessage& b) {
  return same(a.header, b.header) && a.phase == b.phase && a.round == b.round &&
         a.matched_peers == b.matched_peers && a.view_hash == b.view_hash && a.ready == b.ready &&
         a.whole == b.whole && a.view == b.view && a.heartbeats == b.heartbeats;
}
inline bool same(const RouteLeg& a, const RouteLeg& b) {
  return a.arc == b.arc && same(a.from_m, b.from_m) && same(a.to_m, b.to_m) &&
         same(a.waypoints, b.waypoints);
}
inline bool same(const RouteMessage& a, const RouteMessage& b) {
  return same(a.header, b.header) && a.view_hash == b.view_hash &&
         a.owners_digest == b.owners_digest && same(a.length_m, b.length_m) &&
         same(a.time_s, b.time_s) && same(a.legs, b.legs);
}

}  // namespace arcbid
