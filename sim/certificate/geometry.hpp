// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "core/arcs/arc.hpp"

namespace arcbid::certificate {

using Triangle = std::array<Vec3, 3>;

/// The least distance of a straight leg from something, and where on the leg it is.
struct Approach {
  double distance_m = 0;
  double along = 0;  ///< 0: at the leg's beginning, 1: at its end
};

/// Exact up to the rounding of doubles, also for triangles that are a line or a point.
double distance_m(const Vec3& point, const Triangle& triangle);
Approach approach(const Vec3& from, const Vec3& to, const Vec3& point);
Approach approach(const Vec3& from, const Vec3& to, const Triangle& triangle);

}  // namespace arcbid::certificate
