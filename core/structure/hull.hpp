// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "core/arcs/arc.hpp"

namespace arcbid {

using Vec2 = Eigen::Vector2d;
using Ring = std::vector<Vec2>;  ///< a closed polygon; the last vertex joins the first

inline double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// The convex hull of one cluster: counter-clockwise and strictly convex, or a segment (two
/// vertices), or a spot (one).
struct Hull {
  Ring ring;
  std::vector<std::uint32_t> members;  ///< indices of the cluster's points, ascending
};

/// Strictly inside, or nearer to every edge's line than `margin_m` on the outside; false for a
/// segment or a spot, which enclose nothing.
bool contains(const Ring& convex, const Vec2& p, double margin_m = 0);

/// The point of the ring's edges nearest to `p`.
Vec2 nearest_on(const Ring& ring, const Vec2& p);

/// The smallest rectangle around a convex ring, with its own axes.
struct Rectangle {
  Vec2 low = Vec2::Zero();       ///< its corner that is lowest along both axes, in x and y
  Vec2 u = Vec2::UnitX();        ///< unit vector of one side; the other side's is v()
  Vec2 extent_m = Vec2::Zero();  ///< length along u and v
  Vec2 v() const { return {-u.y(), u.x()}; }
  Vec2 at(double along_u_m, double along_v_m) const {
    return low + along_u_m * u + along_v_m * v();
  }
};
Rectangle smallest_rectangle(const Ring& convex);

/// Single-linkage clusters of the points' (x, y): two points closer than `gap_m` are in one
/// cluster. Points are first merged within cells of `cell_m`. Fixed order.
std::vector<Hull> clustered_hulls(const std::vector<Vec3>& points, double gap_m, double cell_m);

/// The outlines at `distance_m` from the hulls, those that overlap united: outer rings
/// counter-clockwise, holes clockwise, so that the hulls are always on the left. Corners are
/// rounded by circumscribed polygons: no point of an outline is nearer than distance_m, none of a
/// lone hull's farther than 1.02 distance_m. Fixed order.
std::vector<Ring> offset_outlines(const std::vector<Hull>& hulls, double distance_m);

}  // namespace arcbid
