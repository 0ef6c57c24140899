// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_set_2.h>
#include <CGAL/convex_hull_2.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/structure/hull.hpp"

namespace arcbid {

namespace {

using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Polygon = CGAL::Polygon_2<Exact>;

constexpr int kCorners = 16;  // of the polygon around the offset circle

/// Minkowski sum of a convex ring and a circle: the convex hull of the circle's polygon at every
/// vertex. The polygon is turned with the hull's smallest rectangle, so that a rectangle's sides
/// are offset exactly.
Polygon offset(const Ring& convex, double distance_m) {
  const Rectangle frame = smallest_rectangle(convex);
  const double radius_m = distance_m / std::cos(std::numbers::pi / kCorners);
  std::vector<Exact::Point_2> sums;
  for (const Vec2& vertex : convex)
    for (int k = 0; k < kCorners; ++k) {
      const double angle = (2 * k + 1) * std::numbers::pi / kCorners;
      const Vec2 p = vertex + radius_m * (std::cos(angle) * frame.u + std::sin(angle) * frame.v());
      sums.emplace_back(p.x(), p.y());
    }
  Polygon polygon;
  CGAL::convex_hull_2(sums.begin(), sums.end(), std::back_inserter(polygon));
  return polygon;
}

/// As doubles, from the lexicographically smallest vertex on: independent of how CGAL stores it.
Ring to_ring(const Polygon& polygon) {
  Ring ring;
  for (const auto& p : polygon.container())
    ring.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()));
  const auto first = std::min_element(ring.begin(), ring.end(), [](const Vec2& a, const Vec2& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  });
  std::rotate(ring.begin(), first, ring.end());
  return ring;
}

}  // namespace

std::vector<Ring> offset_outlines(const std::vector<Hull>& hulls, double distance_m) {
  std::vector<Polygon> offsets;
  for (const Hull& hull : hulls) offsets.push_back(offset(hull.ring, distance_m));
  CGAL::Polygon_set_2<Exact> united;
  united.join(offsets.begin(), offsets.end());
  std::vector<CGAL::Polygon_with_holes_2<Exact>> parts;
  united.polygons_with_holes(std::back_inserter(parts));

  std::vector<Ring> outlines;
  for (const auto& part : parts) {
    outlines.push_back(to_ring(part.outer_boundary()));
    for (const Polygon& hole : part.holes()) outlines.push_back(to_ring(hole));
  }
  std::sort(outlines.begin(), outlines.end(), [](const Ring& a, const Ring& b) {
    return std::lexicographical_compare(a[0].begin(), a[0].end(), b[0].begin(), b[0].end());
  });
  return outlines;
}

}  // namespace arcbid
