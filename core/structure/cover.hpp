// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/structure/structure.hpp"

namespace arcbid {

/// Points that stand for the whole surface when it is sliced and when clearance is asked for.
/// Unlike random samples they have no gaps: whoever keeps `clearance_m(safety_m)` from all of them
/// keeps safety_m from every point of the surface.
struct Cover {
  std::vector<Vec3> points;
  double radius_m = 0;  ///< no surface point is farther than this from a cover point
  bool of_mesh = false;
  double area_m2 = 0;  ///< mesh: its area; cloud: occupied voxels times a voxel's face

  double clearance_m(double safety_m) const;
};

/// Covers with points `spacing_m` apart, or farther where that would be more than two million.
Cover cover(const Structure& structure, double spacing_m);

}  // namespace arcbid
