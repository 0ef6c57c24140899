// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/run/mission_json.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <limits>

#include "core/io/run/event_json.hpp"

namespace arcbid {
namespace {

constexpr std::uint64_t most_32 = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint64_t most_time = std::numeric_limits<TimeNs>::max();
constexpr std::uint64_t most_64 = std::numeric_limits<std::uint64_t>::max();

std::uint32_t whole_32(const JsonPlace& place) {
  return static_cast<std::uint32_t>(place.whole(most_32));
}

TimeNs time_ns(const JsonPlace& place) {
  return static_cast<TimeNs>(place.whole(most_time));
}

template <class E, std::size_t n>
E by_name(const std::array<std::string_view, n>& names, const JsonPlace& place) {
  const std::string name = place.text();
  for (std::size_t i = 0; i < n; ++i)
    if (names[i] == name) return static_cast<E>(i);
  place.refuse(fmt::format("one of {}", fmt::join(names, ", ")));
}

template <std::size_t n>
std::array<double, n> numbers(const JsonPlace& place) {
  const std::vector<JsonPlace> elements = place.elements();
  if (elements.size() != n) place.refuse(fmt::format("a list of {} numbers", n));
  std::array<double, n> out{};
  for (std::size_t i = 0; i < n; ++i) out[i] = elements[i].number();
  return out;
}

Uav uav_of(const JsonPlace& place) {
  const auto home = numbers<3>(place.at("home_m"));
  return {{whole_32(place.at("agent"))}, {home[0], home[1], home[2]}, place.at("speed_mps").number()};
}

Arc arc_of(const JsonPlace& place) {
  constexpr std::array kinds{ArcKind::outline, ArcKind::top_row, ArcKind::underside_row};
  constexpr std::array<std::string_view, 3> names{"outline", "top_row", "underside_row"};
  Arc arc{{whole_32(place.at("arc"))}, {}, {}};
  arc.kind = kinds[by_name<std::size_t>(names, place.at("kind"))];
  for (const JsonPlace& waypoint : place.at("waypoints").elements()) {
    const auto w = numbers<6>(waypoint);
    arc.waypoints.push_back({{w[0], w[1], w[2]}, {w[3], w[4], w[5]}});
  }
  return arc;
}

AuctionSettings auction_of(const JsonPlace& place) {
  AuctionSettings out;
  out.policy = by_name<PolicyKind>(policy_names, place.at("policy"));
  out.score = by_name<ScoreKind>(score_names, place.at("score"));
  out.discount_per_s = place.at("discount_per_s").number();
  if (!place.at("split_m").is_null()) out.split_m = place.at("split_m").number();
  out.max_tasks = whole_32(place.at("max_tasks"));
  out.bundle_limit = whole_32(place.at("bundle_limit"));
  out.audit_bids = place.at("audit_bids").truth();
  out.tick_ns = time_ns(place.at("tick_ns"));
  out.lease_ns = time_ns(place.at("lease_ns"));
  out.barrier_ns = time_ns(place.at("barrier_ns"));
  return out;
}

}  // namespace

Mission mission_of(const JsonPlace& body) {
  Mission mission{.id = body.at("id").hex(), .name = body.at("name").text(), .arcs = {}, .fleet = {},
                  .auction = auction_of(body.at("auction")), .tour = {}};
  for (const JsonPlace& uav : body.at("fleet").elements()) mission.fleet.push_back(uav_of(uav));
  for (const JsonPlace& arc : body.at("arcs").elements()) mission.arcs.push_back(arc_of(arc));
  mission.tour = {body.at("tour").at("seed").whole(most_64),
                  whole_32(body.at("tour").at("epochs"))};
  if (body.at("digest").hex() != digest(mission))
    body.at("digest").refuse(fmt::format("that of this mission, {}", hex(digest(mission))));
  return mission;
}

}  // namespace arcbid
