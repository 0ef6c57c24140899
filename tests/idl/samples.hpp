// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "core/arcs/mission.hpp"
#include "core/auction/message.hpp"

/// One of each kind of message, with a different value in every field.
namespace arcbid::samples {

inline Header header(std::uint32_t sender) {
  return {AgentId{sender}, 1ULL << 42, 17, 0xabcdef, 0x123456};
}

inline Statement claims(std::uint32_t agent, std::uint32_t version = 9) {
  return {AgentId{agent},
          {(1ULL << 42) + agent, false, version},
          Claims{{{TaskId{3}, -1.5}, {TaskId{0}, -0.0}, {TaskId{7}, 0.1}}}};
}

inline Statement table(std::uint32_t agent) {
  return {AgentId{agent},
          {5, true, 11},
          Table{{{AgentId{2}, 0.3}, {std::nullopt, 0}, {AgentId{1}, 5e-324}}, {4, 0, 1ULL << 63}}};
}

inline BidMessage bids(std::uint32_t sender, std::uint32_t version = 9) {
  return {header(sender), claims(sender, version)};
}

inline RelayMessage relay(std::uint32_t sender, std::uint32_t origin) {
  return {header(sender), table(origin)};
}

inline StatusMessage status(std::uint32_t sender) {
  return {header(sender),
          Phase::agreed,
          12,
          3,
          0xfeed,
          {AgentId{1}, AgentId{4}},
          false,
          {{{1}, {1, false, 2}}, {{4}, {3, true, 4}}},
          {{{1}, {5, 6}}, {{9}, {7, 8}}}};
}

inline RouteMessage route(std::uint32_t sender) {
  const Waypoint a{{1, 2, 3}, {0, 0, 1}}, b{{4, 5, 6}, {1, 0, 0}};
  return {header(sender), 0xbeef,
          0xfade,         12.25,
          99.5,           {{std::nullopt, 0, 2.5, {a, b}}, {ArcId{6}, 8.75, 1.25, {b, a, b}}}};
}

inline ControlMessage control() {
  return {0xd16e57, Command::abort, "a drone is missing"};
}

/// `arcs` arcs of `waypoints` each: 48 bytes a waypoint on the wire.
inline Mission mission(std::uint32_t arcs = 2, std::uint32_t waypoints = 3) {
  Mission out;
  out.id = 77;
  out.name = "bridge 7";
  for (std::uint32_t i = 0; i < arcs; ++i) {
    Arc arc{ArcId{i}, static_cast<ArcKind>(i % 3), {}, static_cast<Payload>(i % 3)};
    for (std::uint32_t k = 0; k < waypoints; ++k)
      arc.waypoints.push_back({{i / 3.0, k * 0.1, -1.0 - i}, {0, 0.6, 0.8}});
    out.arcs.push_back(arc);
  }
  out.fleet = {{AgentId{1}, {1, 2, 3}, 1.5, 900.5, Payload::camera},
               {AgentId{5}, {-1, -2, -0.0}, 2.5}};
  out.airspace = {{-1.5, 2, 3}, 0.25, {4, 3, 2}, {20, 3, 1}, {}};
  const Vec3 begin = out.arcs.back().waypoints.back().position_m;
  out.airspace.accesses.push_back({ArcId{arcs - 1}, waypoints - 1, {{begin}, {{7, 8, 9}}}});
  out.auction = {PolicyKind::cbba,
                 ScoreKind::discounted_insert_warped,
                 0.03,
                 4.5,
                 900,
                 7,
                 TradesKind::cheap,
                 false,
                 1'000,
                 2'000,
                 3'000};
  out.tour = {TourSolver::crsom, 1ULL << 63, 42, 43};
  return out;
}

}  // namespace arcbid::samples
