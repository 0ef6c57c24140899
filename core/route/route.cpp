// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/route/route.hpp"

#include <numeric>
#include <utility>

namespace arcbid {
namespace {

TourArc as_tour_arc(const Mission& mission, const Piece& piece) {
  const auto polyline = part(mission.arcs[piece.arc.value].waypoints, piece.from_m, piece.to_m);
  return {polyline.front().position_m, polyline.back().position_m, piece.to_m - piece.from_m};
}

RouteLeg arc_leg(const Mission& mission, const Piece& piece, bool backwards) {
  auto polyline = part(mission.arcs[piece.arc.value].waypoints, piece.from_m, piece.to_m);
  if (!backwards) return {piece.arc, piece.from_m, piece.to_m, std::move(polyline)};
  return {piece.arc, piece.to_m, piece.from_m, reversed(std::move(polyline))};
}

/// On the way the drone already looks where the coming arc will have it look.
RouteLeg transit_leg(const Transit& transit, const Vec3& from, const Vec3& to, const Vec3& look) {
  RouteLeg leg;
  for (const Vec3& point : transit.way(from, to)) leg.waypoints.push_back({point, look});
  leg.to_m = transit.length_m(from, to);
  return leg;
}

std::vector<RouteLeg> legs_of(const Mission& mission, const std::vector<Piece>& pieces,
                              const Tour& tour, const Vec3& home, const Transit& transit) {
  std::vector<RouteLeg> legs;
  Waypoint at{home, -Vec3::UnitZ()};
  for (const Stop& stop : tour.stops) {
    RouteLeg leg = arc_leg(mission, pieces[stop.arc], stop.reversed);
    const Waypoint& begin = leg.waypoints.front();
    if (begin.position_m != at.position_m)
      legs.push_back(transit_leg(transit, at.position_m, begin.position_m, begin.look));
    at = leg.waypoints.back();
    legs.push_back(std::move(leg));
  }
  if (at.position_m != home) legs.push_back(transit_leg(transit, at.position_m, home, at.look));
  return legs;
}

}  // namespace

Route plan_route(const Mission& mission, const TaskSet& tasks, const std::vector<PathStop>& path,
                 const Uav& uav, const Transit& transit, const StillWanted& wanted) {
  std::vector<TaskId> won;
  for (const PathStop& stop : path) won.push_back(stop.task);
  const std::vector<Piece> pieces = combine(tasks, won);
  std::vector<TourArc> arcs;
  for (const Piece& piece : pieces) arcs.push_back(as_tour_arc(mission, piece));
  std::vector<std::uint32_t> auction_order(arcs.size());
  std::iota(auction_order.begin(), auction_order.end(), 0u);

  const Tour priced = best_directions(arcs, auction_order, uav.home_m, transit);
  const Tour crsom = crsom_tour(arcs, uav.home_m, transit, mission.tour);
  const Tour best =
      improved_tour(arcs, uav.home_m, transit, std::vector{crsom, priced}, mission.tour, wanted);
  return {.legs = legs_of(mission, pieces, best, uav.home_m, transit),
          .length_m = best.total_m,
          .time_s = best.total_m / uav.speed_mps,
          .pieces = pieces.size(),
          .auction_order_m = priced.total_m,
          .crsom_m = crsom.total_m};
}

}  // namespace arcbid
