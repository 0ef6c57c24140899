// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>

#include "core/structure/hull.hpp"

namespace arcbid {

bool contains(const Ring& convex, const Vec2& p, double margin_m) {
  if (convex.size() < 3) return false;
  for (std::size_t i = 0; i < convex.size(); ++i) {
    const Vec2& a = convex[i];
    const Vec2& b = convex[(i + 1) % convex.size()];
    if (cross(b - a, p - a) <= -margin_m * (b - a).norm()) return false;
  }
  return true;
}

Vec2 nearest_on(const Ring& ring, const Vec2& p) {
  Vec2 best = ring.front();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2& a = ring[i];
    const Vec2 edge = ring[(i + 1) % ring.size()] - a;
    const double length2 = edge.squaredNorm();
    const double share = length2 > 0 ? std::clamp((p - a).dot(edge) / length2, 0.0, 1.0) : 0.0;
    const Vec2 on = a + share * edge;
    if ((on - p).squaredNorm() < (best - p).squaredNorm()) best = on;
  }
  return best;
}

// One side of the smallest rectangle lies on an edge of the hull (Freeman and Shapira 1975). Plain
// quadratic time: hulls have some tens of vertices, and segments and spots need no special case.
Rectangle smallest_rectangle(const Ring& convex) {
  Rectangle best;
  best.low = convex.front();
  double least_m2 = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < convex.size() && convex.size() > 1; ++i) {
    const Vec2 edge = convex[(i + 1) % convex.size()] - convex[i];
    Rectangle r;
    r.u = edge.normalized();
    Vec2 low = Vec2::Zero(), high = Vec2::Zero();  // relative to vertex i, along u and v
    for (const Vec2& vertex : convex) {
      const Vec2 along((vertex - convex[i]).dot(r.u), (vertex - convex[i]).dot(r.v()));
      low = low.cwiseMin(along);
      high = high.cwiseMax(along);
    }
    r.low = convex[i] + low.x() * r.u + low.y() * r.v();
    r.extent_m = high - low;
    const double area_m2 = r.extent_m.prod();
    // Equal but for rounding: keep the earlier edge.
    if (area_m2 >= least_m2 * (1 - 1e-9)) continue;
    least_m2 = area_m2;
    best = r;
  }
  return best;
}

}  // namespace arcbid
