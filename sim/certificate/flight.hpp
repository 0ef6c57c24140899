// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/arcs/arc.hpp"

namespace arcbid::certificate {

using Path = std::vector<Waypoint>;

struct FlownLeg {
  std::optional<std::uint32_t> arc;  ///< none: transit
  Path waypoints;
};

/// One agent's route, home to home.
struct Flight {
  std::uint32_t agent = 0;
  std::vector<FlownLeg> legs;
};

/// What is certified: the routes, and the arcs that they are made of.
struct Flown {
  std::vector<Flight> flights;
  std::vector<Path> arcs;
};

/// A place on a path from which the surface is looked at.
struct Station {
  Vec3 position_m;
  Vec3 look;
  bool counts = false;     ///< one of those a metre apart, by which redundancy is counted
  bool is_proper = false;  ///< clear of the structure, over the floor, connected to the outside
};

/// Stations at most `step_m` apart along a path, its waypoints among them. Position and look are
/// interpolated, the look made a unit vector again.
std::vector<Station> stations_on(const Path& path, double step_m);

double flown_m(const Path& path);
/// Of all routes.
double flown_m(const Flown& flown);

}  // namespace arcbid::certificate
