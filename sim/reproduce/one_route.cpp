// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/reproduce/one_route.hpp"

#include "core/airspace/obstacle_transit.hpp"
#include "core/tour/tour.hpp"

namespace arcbid::reproduce {

namespace {

/// Where a transit looks is nobody's concern; a sensor that sees all round sees all the same.
certificate::FlownLeg transit_leg(const std::vector<Vec3>& way) {
  certificate::FlownLeg leg;
  for (const Vec3& p : way) leg.waypoints.push_back({p, -Vec3::UnitZ()});
  return leg;
}

}  // namespace

certificate::Flown one_route(const std::vector<Arc>& arcs, const Airspace& airspace,
                             const Vec3& home_m) {
  std::vector<TourArc> nodes;
  certificate::Flown flown;
  for (const Arc& arc : arcs) {
    nodes.push_back({arc.waypoints.front().position_m, arc.waypoints.back().position_m,
                     length_m(arc.waypoints)});
    flown.arcs.push_back(arc.waypoints);
  }
  const ObstacleTransit transit(airspace, arcs, {});
  certificate::Flight flight{1, {}};
  Vec3 at = home_m;
  for (const Stop& stop : plan_tour(nodes, home_m, StraightTransit(), {}).stops) {
    const Arc& arc = arcs[stop.arc];
    certificate::Path path = stop.reversed ? reversed(arc.waypoints) : arc.waypoints;
    flight.legs.push_back(transit_leg(transit.way(at, path.front().position_m)));
    at = path.back().position_m;
    flight.legs.push_back({arc.id.value, std::move(path)});
  }
  flight.legs.push_back(transit_leg(transit.way(at, home_m)));
  flown.flights.push_back(std::move(flight));
  return flown;
}

}  // namespace arcbid::reproduce
