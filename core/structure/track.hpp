// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/arcs/arc.hpp"
#include "core/structure/clearance.hpp"

namespace arcbid {

/// A path line on its way to becoming arcs.
struct Track {
  std::vector<Vec3> points;
  bool closed = false;  ///< the last point joins the first, which is not repeated
};

double length_m(const Track& track);

/// Fewer points: those that can go while the rest stays within `tolerance_m` of them go.
Track simplified(const Track& track, double tolerance_m);

/// More points: neighbours are at most `spacing_m` apart.
Track densified(const Track& track, double spacing_m);

/// The track as far as it may be flown. A stretch that comes too near to the surface is pushed out,
/// by at most `push_m`; where that fails it is left out, and the track falls into open ones.
/// Stretches shorter than `least_m` are left out too. Neighbouring points stay at most `spacing_m`
/// apart. Adds the length left out to `lost_m`.
struct Repair {
  double spacing_m, push_m, least_m;
};
std::vector<Track> kept_clear(const Track& track, const Clearance& clearance, const Repair& repair,
                              double& lost_m);

}  // namespace arcbid
