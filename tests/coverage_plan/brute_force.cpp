// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/coverage_plan/brute_force.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <boost/random/uniform_real_distribution.hpp>
#include <cmath>
#include <numbers>
#include <queue>
#include <random>

#include "tests/structure/arc_laws.hpp"

namespace arcbid {

namespace {

constexpr double kDegree = std::numbers::pi / 180;

Vec3 nearest_on_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return a + t * (b - a);
}

double distance_to_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  double best =
      std::min({(p - nearest_on_segment(p, a, b)).norm(), (p - nearest_on_segment(p, b, c)).norm(),
                (p - nearest_on_segment(p, c, a)).norm()});
  Eigen::Matrix<double, 3, 2> edges;
  edges << b - a, c - a;
  const Eigen::Vector2d uv = (edges.transpose() * edges).ldlt().solve(edges.transpose() * (p - a));
  if (uv.x() >= 0 && uv.y() >= 0 && uv.sum() <= 1)
    best = std::min(best, (p - a - edges * uv).norm());
  return best;
}

}  // namespace

BruteForce::BruteForce(const Structure& mesh, const CoverageSettings& settings)
    : mesh_(mesh), settings_(settings) {
  double low = mesh.points.front().z();
  for (const Vec3& p : mesh.points) low = std::min(low, p.z());
  floor_m_ = settings.ground_m.value_or(low) + settings.ground_clearance_m;
}

double BruteForce::distance_m(const Vec3& p) const {
  double best = 1e9;
  for (const auto& [a, b, c] : mesh_.triangles)
    best =
        std::min(best, distance_to_triangle(p, mesh_.points[a], mesh_.points[b], mesh_.points[c]));
  return best;
}

/// Cramer's rule for from + t (to - from) = a + u (b - a) + v (c - a).
bool BruteForce::hidden(const Vec3& from, const Vec3& to) const {
  for (const auto& [ia, ib, ic] : mesh_.triangles) {
    Eigen::Matrix3d m;
    m << from - to, mesh_.points[ib] - mesh_.points[ia], mesh_.points[ic] - mesh_.points[ia];
    const double det = m.determinant();
    if (std::abs(det) < 1e-12) continue;
    const Vec3 tuv = m.inverse() * (from - mesh_.points[ia]);
    if (tuv.x() > 0 && tuv.x() < 1 && tuv.y() >= 0 && tuv.z() >= 0 && tuv.y() + tuv.z() <= 1)
      return true;
  }
  return false;
}

std::vector<BruteForce::Sample> BruteForce::samples(std::uint32_t seed) const {
  std::mt19937 random(seed);
  boost::random::uniform_real_distribution<double> uniform(0, 1);
  std::vector<Sample> all;
  for (const auto& [ia, ib, ic] : mesh_.triangles) {
    const Vec3 &a = mesh_.points[ia], ab = mesh_.points[ib] - a, ac = mesh_.points[ic] - a;
    const Vec3 normal = ab.cross(ac);
    for (double n = 0.5 * normal.norm() / 0.16 - uniform(random); n > 0; --n) {
      double u = uniform(random), v = uniform(random);
      if (u + v > 1) {
        u = 1 - u;
        v = 1 - v;
      }
      all.push_back({a + u * ab + v * ac, normal.normalized()});
      all.push_back({all.back().point, -all.back().normal});
    }
  }
  return all;
}

std::vector<Vec3> BruteForce::flyable_places() const {
  constexpr double step = 0.5;
  Vec3 low = mesh_.points.front(), high = low;
  for (const Vec3& p : mesh_.points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Vec3 start = Vec3(low.x() - 9, low.y() - 9, std::max(low.z() - 9, floor_m_));
  const Eigen::Array3i size =
      ((high + Vec3::Constant(9) - start) / step).array().ceil().cast<int>();
  std::vector<bool> seen(static_cast<std::size_t>(size.prod()));
  std::queue<std::array<int, 3>> queue;
  std::vector<Vec3> places;
  const auto visit = [&](int x, int y, int z) {
    if (x < 0 || y < 0 || z < 0 || x >= size.x() || y >= size.y() || z >= size.z()) return;
    const auto k = static_cast<std::size_t>((z * size.y() + y) * size.x() + x);
    if (seen[k]) return;
    seen[k] = true;
    const Vec3 p = start + step * Vec3(x, y, z);
    if (distance_m(p) < settings_.safety_m) return;
    places.push_back(p);
    queue.push({x, y, z});
  };
  for (visit(0, 0, size.z() - 1); !queue.empty(); queue.pop()) {
    const auto [x, y, z] = queue.front();
    visit(x + 1, y, z), visit(x - 1, y, z), visit(x, y + 1, z);
    visit(x, y - 1, z), visit(x, y, z + 1), visit(x, y, z - 1);
  }
  return places;
}

bool BruteForce::sees(const Waypoint& from, const Sample& sample, bool aimed) const {
  const Sensor& s = settings_.sensor;
  const Vec3 way = sample.point - from.position_m;
  const double m = way.norm();
  if (m > s.range_m || m < s.least_range_m) return false;
  if (-way.dot(sample.normal) < m * std::cos(s.max_incidence_deg * kDegree)) return false;
  if (!aimed && !s.all_round()) {
    const Vec3 right = from.look.cross(Vec3::UnitZ());
    if (right.norm() < 1e-3) {
      const double off = std::acos(std::clamp(way.dot(from.look) / m, -1.0, 1.0));
      if (off > 0.5 * kDegree * std::min(s.horizontal_fov_deg, s.vertical_fov_deg)) return false;
    } else {
      const Vec3 up = right.normalized().cross(from.look);
      const double ahead = way.dot(from.look);
      if (ahead <= 0 ||
          std::abs(way.dot(right.normalized())) >
              ahead * std::tan(s.horizontal_fov_deg / 2 * kDegree) ||
          std::abs(way.dot(up)) > ahead * std::tan(s.vertical_fov_deg / 2 * kDegree))
        return false;
    }
  }
  return !hidden(sample.point + 0.01 * sample.normal, from.position_m);
}

BruteForce::Count BruteForce::count(const std::vector<Arc>& arcs, std::uint32_t seed) const {
  const std::vector<Vec3> places = flyable_places();
  std::vector<Waypoint> flown;
  for (const Arc& arc : arcs) {
    const double length = length_m(arc.waypoints);
    flown.push_back(arc.waypoints.front());
    for (double m = 0.5; m < length; m += 0.5)
      flown.push_back(part(arc.waypoints, m - 0.25, m).back());
    for (const Waypoint& w : arc.waypoints) flown.push_back(w);
  }
  Count count;
  for (const Sample& sample : samples(seed)) {
    ++count.samples;
    const bool covered = std::any_of(flown.begin(), flown.end(),
                                     [&](const Waypoint& w) { return sees(w, sample, false); });
    count.covered += covered;
    count.visible += covered || std::any_of(places.begin(), places.end(), [&](const Vec3& p) {
                       return sees({p, Vec3::UnitX()}, sample, true);
                     });
  }
  return count;
}

double BruteForce::least_clearance_m(const std::vector<Arc>& arcs) const {
  double least = 1e9;
  for (const Vec3& p : along_arcs(arcs, 0.05)) least = std::min(least, distance_m(p));
  return least;
}

}  // namespace arcbid
