// SPDX-License-Identifier: GPL-3.0-or-later
// What records are made of, said once: bytes, their schema and the JSON of people all follow from
// this. A visitor is called with the name and the value of every field, in their order; one of
// several kinds is a choice.
#pragma once

#include <array>
#include <concepts>
#include <string_view>

#include "core/io/record/records.hpp"

namespace arcbid {

template <class S, class T>
concept Is = std::same_as<std::remove_const_t<S>, T>;

/// The name of a record's type in its schema.
template <class T>
inline constexpr std::string_view record_name{};

#define ARCBID_RECORD(Type)                                    \
  template <>                                                  \
  inline constexpr std::string_view record_name<Type> = #Type; \
  template <class V, Is<Type> S>                               \
  void fields(V& v, S& s)

ARCBID_RECORD(StatementKey) {
  v("incarnation", s.incarnation);
  v("dead", s.dead);
  v("version", s.version);
}
ARCBID_RECORD(Claim) {
  v("task", s.task);
  v("bid", s.bid);
}
ARCBID_RECORD(Claims) {
  v("bundle", s.bundle);
}
ARCBID_RECORD(Belief) {
  v("winner", s.winner);
  v("bid", s.bid);
}
ARCBID_RECORD(Table) {
  v("beliefs", s.beliefs);
  v("timestamps", s.timestamps);
}
inline constexpr std::array<std::string_view, 2> body_kinds{"claims", "table"};
ARCBID_RECORD(Statement) {
  v("agent", s.agent);
  v("key", s.key);
  v.choice(body_kinds, s.body);
}
ARCBID_RECORD(Header) {
  v("sender", s.sender);
  v("incarnation", s.incarnation);
  v("sequence", s.sequence);
  v("mission_digest", s.mission_digest);
  v("task_digest", s.task_digest);
}
ARCBID_RECORD(BidMessage) {
  v("header", s.header);
  v("statement", s.statement);
}
ARCBID_RECORD(RelayMessage) {
  v("header", s.header);
  v("statement", s.statement);
}
ARCBID_RECORD(Heartbeat) {
  v("incarnation", s.incarnation);
  v("counter", s.counter);
}
ARCBID_RECORD(Held) {
  v("agent", s.agent);
  v("key", s.key);
}
ARCBID_RECORD(Pulse) {
  v("agent", s.agent);
  v("heartbeat", s.heartbeat);
}
ARCBID_RECORD(StatusMessage) {
  v("header", s.header);
  v("phase", s.phase);
  v("round", s.round);
  v("matched_peers", s.matched_peers);
  v("view_hash", s.view_hash);
  v("ready", s.ready);
  v("whole", s.whole);
  v("view", s.view);
  v("heartbeats", s.heartbeats);
}
ARCBID_RECORD(Tick) {
  v("matched_peers", s.matched_peers);
}
ARCBID_RECORD(RoutePublished) {
  v("view_hash", s.view_hash);
}
inline constexpr std::array<std::string_view, 5> event_kinds{"tick", "bid", "relay", "status",
                                                             "route_published"};
ARCBID_RECORD(Event) {
  v("now_ns", s.now_ns);
  v.choice(event_kinds, s.what);
}
ARCBID_RECORD(PathStop) {
  v("task", s.task);
  v("reversed", s.reversed);
}
ARCBID_RECORD(DecisionMade) {
  v("round", s.round);
  v("changed", s.changed);
  v("key", s.key);
  v.choice(body_kinds, s.body);
  v("path", s.path);
}
ARCBID_RECORD(NoBidder) {
  v("arc", s.arc);
  v("from_m", s.from_m);
  v("to_m", s.to_m);
  v("why", s.why);
  v("needs", s.needs);
  v("nearest", s.nearest);
  v("needed_s", s.needed_s);
  v("endurance_s", s.endurance_s);
  v("limit", s.limit);
}
ARCBID_RECORD(Taken) {
  v("agent", s.agent);
  v("tasks", s.tasks);
}
ARCBID_RECORD(Agreement) {
  v("view_hash", s.view_hash);
  v("round", s.round);
  v("members", s.members);
  v("winners", s.winners);
  v("path", s.path);
  v("taken", s.taken);
  v("left", s.left);
}
ARCBID_RECORD(Update) {
  v("bids", s.bids);
  v("relays", s.relays);
  v("statuses", s.statuses);
  v("refused", s.refused);
  v("died", s.died);
  v("returned", s.returned);
  v("decision", s.decision);
  v("started", s.started);
  v("agreement_lost", s.agreement_lost);
  v("agreed", s.agreed);
  v("wake_ns", s.wake_ns);
}
ARCBID_RECORD(Step) {
  v("event", s.event);
  v("update", s.update);
}
ARCBID_RECORD(Birth) {
  v("agent", s.agent);
  v("incarnation", s.incarnation);
  v("now_ns", s.now_ns);
}
ARCBID_RECORD(Waypoint) {
  v("position_m", s.position_m);
  v("look", s.look);
}
ARCBID_RECORD(RouteLeg) {
  v("arc", s.arc);
  v("from_m", s.from_m);
  v("to_m", s.to_m);
  v("waypoints", s.waypoints);
}
ARCBID_RECORD(Route) {
  v("legs", s.legs);
  v("length_m", s.length_m);
  v("time_s", s.time_s);
  v("pieces", s.pieces);
  v("auction_order_m", s.auction_order_m);
  v("crsom_m", s.crsom_m);
}
ARCBID_RECORD(PlannedRoute) {
  v("view_hash", s.view_hash);
  v("route", s.route);
}
ARCBID_RECORD(Arc) {
  v("id", s.id);
  v("kind", s.kind);
  v("waypoints", s.waypoints);
  v("payload", s.payload);
}
ARCBID_RECORD(Uav) {
  v("id", s.id);
  v("home_m", s.home_m);
  v("speed_mps", s.speed_mps);
  v("endurance_s", s.endurance_s);
  v("payload", s.payload);
}
ARCBID_RECORD(AuctionSettings) {
  v("policy", s.policy);
  v("score", s.score);
  v("discount_per_s", s.discount_per_s);
  v("split_m", s.split_m);
  v("max_tasks", s.max_tasks);
  v("bundle_limit", s.bundle_limit);
  v("trades", s.trades);
  v("audit_bids", s.audit_bids);
  v("tick_ns", s.tick_ns);
  v("lease_ns", s.lease_ns);
  v("barrier_ns", s.barrier_ns);
}
ARCBID_RECORD(TourSettings) {
  v("solver", s.solver);
  v("seed", s.seed);
  v("epochs", s.epochs);
  v("iterations", s.iterations);
}
ARCBID_RECORD(AccessPoint) {
  v("position_m", s.position_m);
}
ARCBID_RECORD(Access) {
  v("arc", s.arc);
  v("waypoint", s.waypoint);
  v("points", s.points);
}
ARCBID_RECORD(Airspace) {
  v("low_m", s.low_m);
  v("cell_m", s.cell_m);
  v("cells_x", s.cells[0]);
  v("cells_y", s.cells[1]);
  v("cells_z", s.cells[2]);
  v("runs", s.runs);
  v("accesses", s.accesses);
}
ARCBID_RECORD(Mission) {
  v("id", s.id);
  v("name", s.name);
  v("arcs", s.arcs);
  v("fleet", s.fleet);
  v("airspace", s.airspace);
  v("auction", s.auction);
  v("tour", s.tour);
}

#undef ARCBID_RECORD

}  // namespace arcbid
