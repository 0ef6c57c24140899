// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/certificate/surface.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace arcbid::certificate {
namespace {

constexpr double level_m = 0.5;      // what lies no higher over the lowest point is at its level
constexpr double flat = 0.9;         // vertical part of a normal
constexpr double footprint_m = 2.0;  // cells in which it is seen what stands where
constexpr double beyond_share = 0.3, beyond_m2 = 20.0;

using Spot = std::pair<std::int64_t, std::int64_t>;

Spot spot_of(const Vec3& position) {
  return {static_cast<std::int64_t>(std::floor(position.x() / footprint_m)),
          static_cast<std::int64_t>(std::floor(position.y() / footprint_m))};
}

/// The cells that something stands in, and those around them.
std::set<Spot> footprint(const std::vector<SurfacePoint>& points, const std::vector<bool>& is_low) {
  std::set<Spot> spots;
  for (std::size_t p = 0; p < points.size(); ++p) {
    if (is_low[p]) continue;
    const Spot spot = spot_of(points[p].position_m);
    for (int dx = -1; dx <= 1; ++dx)
      for (int dy = -1; dy <= 1; ++dy) spots.insert({spot.first + dx, spot.second + dy});
  }
  return spots;
}

}  // namespace

std::uint64_t mixed(std::uint64_t seed, std::uint64_t number) {
  std::uint64_t z = seed + (number + 1) * 0x9e3779b97f4a7c15u;  // SplitMix64 (Steele et al. 2014)
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

double share_of(std::uint64_t bits) {
  return static_cast<double>(bits >> 11) * 0x1p-53;
}

void set_ground_aside(Surface& surface) {
  std::vector<SurfacePoint>& points = surface.points;
  if (points.empty()) return;
  double lowest_m = points.front().position_m.z();
  for (const SurfacePoint& p : points) lowest_m = std::min(lowest_m, p.position_m.z());
  std::vector<bool> is_low(points.size());
  for (std::size_t p = 0; p < points.size(); ++p)
    is_low[p] =
        points[p].position_m.z() <= lowest_m + level_m && std::abs(points[p].normal.z()) >= flat;
  const std::set<Spot> standing = footprint(points, is_low);
  if (standing.empty()) return;  // nothing but a level surface: then it is what is to be seen
  double low_m2 = 0, outside_m2 = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    if (!is_low[p]) continue;
    low_m2 += points[p].area_m2;
    if (!standing.contains(spot_of(points[p].position_m))) outside_m2 += points[p].area_m2;
  }
  if (outside_m2 < beyond_m2 || outside_m2 < beyond_share * low_m2) return;
  std::vector<SurfacePoint> kept;
  for (std::size_t p = 0; p < points.size(); ++p)
    (is_low[p] ? surface.ground : kept).push_back(points[p]);
  points = std::move(kept);
}

Surface surface_of(const Structure& structure, const SurfaceSettings& settings) {
  Surface surface;
  if (structure.is_mesh())
    sample_mesh(structure, settings, surface);
  else
    sample_cloud(structure, settings, surface);
  set_ground_aside(surface);
  return surface;
}

}  // namespace arcbid::certificate
