// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "sim/certificate/flight.hpp"
#include "sim/certificate/free_space.hpp"
#include "sim/certificate/sensing.hpp"
#include "sim/certificate/sight_lines.hpp"
#include "sim/certificate/surface.hpp"

namespace arcbid::certificate {

/// One side of a surface point.
struct Sample {
  Vec3 position_m;
  Vec3 normal;  ///< unit, to the side that is looked at
  Vec3 eye_m;   ///< where sight lines begin: a little over the surface
  double area_m2 = 0;
};

/// Two of each point; a sight line begins at least `least_offset_m` over the surface.
std::vector<Sample> both_sides(const std::vector<SurfacePoint>& points, double least_offset_m);

/// How a sample is seen from the stations of a path.
struct Seen {
  std::uint32_t times = 0;  ///< stretches of 1 m from which it is seen
  bool properly = false;    ///< from a station that is_proper
};

/// For every sample. A sample that no counting station sees is looked for from those in between,
/// and counts once then.
std::vector<Seen> seen_from(const std::vector<Station>& stations,
                            const std::vector<Sample>& samples, const Sensing& sensing,
                            const SightLines& lines, unsigned threads);

/// Says of each station whether a drone may be there; 1 mm is forgiven, as it is to the routes.
void judge(std::vector<Station>& stations, const FreeSpace& space, unsigned threads);

}  // namespace arcbid::certificate
