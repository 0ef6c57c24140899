// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/coverage/surface.hpp"

#include <algorithm>

#include "core/coverage/surfels.hpp"
#include "core/structure/voxels.hpp"

namespace arcbid {

namespace {

constexpr double kSurfel_m = 0.15;  // between surfels where the cloud is dense
constexpr std::size_t kMostSurfels = 600'000;

/// They are not part of the surface; far away, they would spoil its middle and its extent.
void drop_unused_vertices(Surface& s) {
  std::vector<std::uint32_t> number(s.points.size());
  for (const auto& t : s.triangles)
    for (const std::uint32_t v : t) number[v] = 1;
  std::uint32_t kept = 0;
  for (std::size_t v = 0; v < s.points.size(); ++v) {
    if (number[v] == 0) continue;
    number[v] = kept;
    s.points[kept++] = s.points[v];
  }
  s.points.resize(kept);
  for (auto& t : s.triangles)
    for (std::uint32_t& v : t) v = number[v];
}

std::vector<Vec3> thinned(const std::vector<Vec3>& points, double voxel_m, std::size_t most) {
  std::vector<Vec3> kept = one_per_voxel(points, voxel_m);
  while (kept.size() > most) kept = one_per_voxel(points, voxel_m *= 1.5);
  return kept;
}

}  // namespace

Surface bare_surface(const Structure& structure) {
  Surface s;
  s.points = structure.points;
  s.triangles = structure.triangles;
  if (s.is_mesh()) drop_unused_vertices(s);
  Vec3 low = s.points.front(), high = low;
  for (const Vec3& p : s.points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  s.origin_m = 0.5 * (low + high);
  for (Vec3& p : s.points) p -= s.origin_m;
  return s;
}

Surface surface_of(const Structure& structure, const std::vector<Vec3>& ground, unsigned threads) {
  Surface s = bare_surface(structure);
  if (s.is_mesh()) return s;

  std::vector<Vec3> thin = thinned(s.points, kSurfel_m, kMostSurfels), local_ground;
  s.inspected = thin.size();
  for (const Vec3& p : ground) local_ground.push_back(p - s.origin_m);
  s.points.insert(s.points.end(), local_ground.begin(), local_ground.end());
  local_ground = thinned(local_ground, 2 * kSurfel_m, kMostSurfels);
  thin.insert(thin.end(), local_ground.begin(), local_ground.end());
  s.surfels = surfels_of(thin, threads);
  return s;
}

}  // namespace arcbid
