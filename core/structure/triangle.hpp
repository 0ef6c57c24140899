// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include "core/structure/structure.hpp"

namespace arcbid {

struct Triangle {
  Vec3 a, b, c;
};

inline Triangle triangle(const Structure& mesh, std::size_t index) {
  const auto& [a, b, c] = mesh.triangles[index];
  return {mesh.points[a], mesh.points[b], mesh.points[c]};
}

inline double area_of(const Triangle& t) {
  return 0.5 * (t.b - t.a).cross(t.c - t.a).norm();
}

}  // namespace arcbid
