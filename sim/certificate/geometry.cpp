// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/certificate/geometry.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace arcbid::certificate {
namespace {

double clamped(double value) {
  return std::clamp(value, 0.0, 1.0);
}

/// Where on a segment the nearest point to `point` is; 0 for a segment without length.
double nearest_along(const Vec3& from, const Vec3& to, const Vec3& point) {
  const Vec3 leg = to - from;
  const double squared = leg.squaredNorm();
  return squared > 0 ? clamped((point - from).dot(leg) / squared) : 0;
}

void keep_nearer(Approach& best, const Approach& other) {
  if (other.distance_m < best.distance_m) best = other;
}

/// Of two segments. The nearest pair is in the inside of both, or an end of one takes part; so the
/// solution for the two lines counts where it lies on both segments, and the four ends always.
Approach between(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  Approach best = approach(a, b, c);
  keep_nearer(best, approach(a, b, d));
  const auto end = [&](const Vec3& point, double along) {
    const double on_other = nearest_along(c, d, point);
    keep_nearer(best, {(c + on_other * (d - c) - point).norm(), along});
  };
  end(a, 0);
  end(b, 1);
  const Vec3 u = b - a, v = d - c, w = a - c;
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v);
  const double determinant = uu * vv - uv * uv;
  if (determinant <= 0) return best;  // parallel: the ends have said it
  const double s = (uv * v.dot(w) - vv * u.dot(w)) / determinant;
  const double t = (uu * v.dot(w) - uv * u.dot(w)) / determinant;
  if (s >= 0 && s <= 1 && t >= 0 && t <= 1) keep_nearer(best, {(w + s * u - t * v).norm(), s});
  return best;
}

/// Whether the foot of `point` on the triangle's plane is in the triangle. `normal` is not zero.
bool is_above(const Vec3& point, const Triangle& t, const Vec3& normal) {
  for (int side = 0; side < 3; ++side) {
    const Vec3 &p = t[side], &q = t[(side + 1) % 3];
    if ((q - p).cross(point - p).dot(normal) < 0) return false;
  }
  return true;
}

Vec3 normal_of(const Triangle& t) {
  return (t[1] - t[0]).cross(t[2] - t[0]);
}

}  // namespace

double distance_m(const Vec3& point, const Triangle& triangle) {
  const Vec3 normal = normal_of(triangle);
  const double length = normal.norm();
  if (length > 0 && is_above(point, triangle, normal))
    return std::abs((point - triangle[0]).dot(normal)) / length;
  double best = (point - triangle[0]).norm();
  for (int side = 0; side < 3; ++side)
    best = std::min(best, approach(triangle[side], triangle[(side + 1) % 3], point).distance_m);
  return best;
}

Approach approach(const Vec3& from, const Vec3& to, const Vec3& point) {
  const double along = nearest_along(from, to, point);
  return {(from + along * (to - from) - point).norm(), along};
}

Approach approach(const Vec3& from, const Vec3& to, const Triangle& triangle) {
  Approach best{distance_m(from, triangle), 0};
  keep_nearer(best, {distance_m(to, triangle), 1});
  for (int side = 0; side < 3; ++side)
    keep_nearer(best, between(from, to, triangle[side], triangle[(side + 1) % 3]));
  const Vec3 normal = normal_of(triangle);
  const double before = (from - triangle[0]).dot(normal), after = (to - triangle[0]).dot(normal);
  if (before * after < 0) {
    const double along = before / (before - after);
    if (is_above(from + along * (to - from), triangle, normal)) return {0, along};
  }
  return best;
}

}  // namespace arcbid::certificate
