// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/certificate/geometry.hpp"
#include "sim/certificate/surface.hpp"

namespace arcbid::certificate {
namespace {

constexpr double most_points = 4e6, least_points = 500;
// The plastic number's powers: the sequence in two dimensions that fills a square most evenly.
constexpr double first_step = 0.7548776662466927, second_step = 0.5698402909980532;

double wrapped(double value) {
  return value - std::floor(value);
}

/// Number `n` of a triangle's points; a square folded along its diagonal is a triangle.
Vec3 spread_point(const Triangle& t, std::uint64_t n, double shift_a, double shift_b) {
  const double number = static_cast<double>(n);
  double a = wrapped(shift_a + number * first_step), b = wrapped(shift_b + number * second_step);
  if (a + b > 1) {
    a = 1 - a;
    b = 1 - b;
  }
  return t[0] + a * (t[1] - t[0]) + b * (t[2] - t[0]);
}

}  // namespace

Structure used_part(const Structure& mesh) {
  constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> number(mesh.points.size(), unused);
  Structure used;
  used.triangles = mesh.triangles;
  for (auto& triangle : used.triangles)
    for (std::uint32_t& corner : triangle) {
      std::uint32_t& own = number[corner];
      if (own == unused) {
        own = static_cast<std::uint32_t>(used.points.size());
        used.points.push_back(mesh.points[corner]);
      }
      corner = own;
    }
  return used;
}

void sample_mesh(const Structure& mesh, const SurfaceSettings& settings, Surface& surface) {
  const auto triangle = [&mesh](std::size_t number) {
    const auto& c = mesh.triangles[number];
    return Triangle{mesh.points[c[0]], mesh.points[c[1]], mesh.points[c[2]]};
  };
  std::vector<double> areas(mesh.triangles.size());
  double total_m2 = 0;
  for (std::size_t t = 0; t < areas.size(); ++t) {
    const Triangle corners = triangle(t);
    areas[t] = 0.5 * (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm();
    total_m2 += areas[t];
  }
  if (!(total_m2 > 0)) return;
  const double wanted = total_m2 / (settings.spacing_m * settings.spacing_m);
  const double each_m2 = total_m2 / std::clamp(std::ceil(wanted), least_points, most_points);
  surface.spacing_m = std::sqrt(each_m2);
  // Points lie each_m2 apart along all areas put in a row, from a random beginning.
  double next_m2 = each_m2 * share_of(mixed(settings.seed, 0)), passed_m2 = 0;
  for (std::size_t t = 0; t < areas.size(); ++t) {
    passed_m2 += areas[t];
    const Triangle corners = triangle(t);
    const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
    const double a = share_of(mixed(settings.seed, 2 * t + 1)),
                 b = share_of(mixed(settings.seed, 2 * t + 2));
    for (std::uint64_t n = 0; next_m2 < passed_m2; ++n, next_m2 += each_m2)
      surface.points.push_back({spread_point(corners, n, a, b), normal, each_m2, 0});
  }
}

}  // namespace arcbid::certificate
