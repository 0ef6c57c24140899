// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/airspace/scenes.hpp"

#include <algorithm>
#include <cmath>

#include "core/structure/triangle.hpp"

namespace arcbid {
namespace {

double to_segment_m(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 step = b - a;
  const double squared = step.squaredNorm();
  const double share = squared > 0 ? std::clamp((p - a).dot(step) / squared, 0.0, 1.0) : 0;
  return (a + share * step - p).norm();
}

double to_triangle_m(const Vec3& p, const Triangle& t) {
  const Vec3 normal = (t.b - t.a).cross(t.c - t.a);
  const double edges_m =
      std::min({to_segment_m(p, t.a, t.b), to_segment_m(p, t.b, t.c), to_segment_m(p, t.c, t.a)});
  const double squared = normal.squaredNorm();
  if (squared == 0) return edges_m;
  const auto left = [&](const Vec3& a, const Vec3& b) {
    return (b - a).cross(p - a).dot(normal) >= 0;
  };
  if (!left(t.a, t.b) || !left(t.b, t.c) || !left(t.c, t.a)) return edges_m;
  return std::abs((p - t.a).dot(normal)) / std::sqrt(squared);
}

}  // namespace

Site::Site(Structure what, CoverageSettings how)
    : structure(std::move(what)),
      settings(how),
      surroundings(structure, settings),
      airspace(surroundings.airspace(arcs, warnings)),
      grid(airspace) {}

double Site::distance_m(const Vec3& p) const {
  double least = 1e30;
  for (std::size_t t = 0; t < structure.triangles.size(); ++t)
    least = std::min(least, to_triangle_m(p, triangle(structure, t)));
  return least;
}

double Site::least_m(const std::vector<Vec3>& way, double step_m) const {
  double least = 1e30;
  for (std::size_t n = 1; n < way.size(); ++n) {
    const double steps = std::ceil((way[n] - way[n - 1]).norm() / step_m);
    for (double k = 0; k <= steps; ++k)
      least = std::min(least,
                       distance_m(way[n - 1] + k / std::max(steps, 1.0) * (way[n] - way[n - 1])));
  }
  return least;
}

Vec3 Site::free_place(Random& random) const {
  const Vec3 high_m = airspace.low_m + airspace.cell_m * Vec3(airspace.cells[0], airspace.cells[1],
                                                              airspace.cells[2]);
  while (true) {
    const Vec3 p(real(random, airspace.low_m.x() - 5, high_m.x() + 5),
                 real(random, airspace.low_m.y() - 5, high_m.y() + 5),
                 real(random, airspace.low_m.z(), high_m.z() + 5));
    if (grid.free(p)) return p;
  }
}

Structure some_boxes(Random& random) {
  Structure all;
  for (int n = boost::random::uniform_int_distribution<int>(1, 6)(random); n > 0; --n) {
    const double x = real(random, -25, 20), y = real(random, -25, 20), z = real(random, 0, 15);
    const Vec3 low(x, y, real(random, 0, 1) < 0.5 ? 0 : z);
    const double length = real(random, 0.1, 25), width = real(random, 0.1, 10);
    const Vec3 high = low + Vec3(length, width, real(random, 0.2, 25));
    all = joined(all, box_mesh(low, high, real(random, 0, 3)));
  }
  return all;
}

Structure sealed_box() {
  Structure all;
  for (int axis = 0; axis < 3; ++axis)
    for (const double at : {0.0, 15.0}) {
      Vec3 low(0, 0, 5), high(16, 16, 21);
      low[axis] += at;
      high[axis] = low[axis] + 1;
      all = joined(all, box_mesh(low, high));
    }
  return all;
}

}  // namespace arcbid
