// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_01.hpp>
#include <cmath>

#include "core/base/error.hpp"
#include "core/coverage/surface.hpp"
#include "core/structure/voxels.hpp"

namespace arcbid {

namespace {

constexpr double kMostPlaces = 5e6;
constexpr double kSortCell_m = 0.25;
constexpr float kMeshLift_m = 0.01F;  // far less than any member is thick

/// Places and normals, before they get sides.
struct Places {
  std::vector<Vec3> points;
  std::vector<Vec3f> normals;
  std::vector<float> lifts_m;
};

/// Every triangle gets its share of the places, rounded up or down by chance; in it they follow a
/// low-discrepancy sequence (Roberts's R2, shifted by chance), which leaves smaller holes than
/// independent places do.
Places places_on_mesh(const Surface& s, double spacing_m, std::uint64_t seed) {
  boost::random::mt19937_64 random(seed);
  boost::random::uniform_01<double> uniform;
  Places places;
  double sum = uniform(random);
  for (const auto& [ia, ib, ic] : s.triangles) {
    const Vec3 &a = s.points[ia], ab = s.points[ib] - a, ac = s.points[ic] - a;
    const Vec3 normal = ab.cross(ac);
    const double before = std::floor(sum);
    sum += 0.5 * normal.norm() / (spacing_m * spacing_m);
    if (sum > kMostPlaces)
      throw InputError(fmt::format(
          "structure: its surface is too large for samples {} m apart (check the file's unit)",
          spacing_m));
    double u = uniform(random), v = uniform(random);
    for (double k = before; k < std::floor(sum); ++k) {
      const bool beyond = u + v > 1;  // the parallelogram's other half
      places.points.push_back(a + (beyond ? 1 - u : u) * ab + (beyond ? 1 - v : v) * ac);
      places.normals.push_back(normal.normalized().cast<float>());
      places.lifts_m.push_back(kMeshLift_m);
      u = std::fmod(u + 0.7548776662466927, 1.0);
      v = std::fmod(v + 0.5698402909980532, 1.0);
    }
  }
  return places;
}

/// One surfel a voxel, chosen by chance.
Places places_on_cloud(const Surface& s, double spacing_m, std::uint64_t seed) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < s.inspected; ++i)
    points.push_back(s.surfels[i].point_m.cast<double>());
  const PointCells cells = group(points, spacing_m, CellShape::voxel);
  boost::random::mt19937_64 random(seed);
  Places places;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const std::uint32_t size = cells.starts[c + 1] - cells.starts[c];
    const std::uint32_t i = cells.order[cells.starts[c] + random() % size];
    places.points.push_back(points[i]);
    places.normals.push_back(s.surfels[i].normal);
    places.lifts_m.push_back(s.surfels[i].lift_m);
  }
  return places;
}

/// Every third bit, from the lowest of 21.
std::uint64_t spread(std::uint64_t x) {
  x &= 0x1FFFFF;
  x = (x | x << 32) & 0x1F00000000FFFF;
  x = (x | x << 16) & 0x1F0000FF0000FF;
  x = (x | x << 8) & 0x100F00F00F00F00F;
  x = (x | x << 4) & 0x10C30C30C30C30C3;
  return (x | x << 2) & 0x1249249249249249;
}

/// Along a Z curve: what is looked at together then also stands together, in packets of rays and in
/// boxes around them.
std::vector<std::uint32_t> near_order(const std::vector<Vec3>& points) {
  Vec3 low = points.front();
  for (const Vec3& p : points) low = low.cwiseMin(p);
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keys;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const Vec3 cell = (points[i] - low) / kSortCell_m;
    std::uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis)
      key |= spread(static_cast<std::uint64_t>(cell[axis])) << axis;
    keys.emplace_back(key, i);
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::uint32_t> order;
  for (const auto& [key, i] : keys) order.push_back(i);
  return order;
}

}  // namespace

Samples sided_samples(const Surface& surface, double spacing_m, std::uint64_t seed) {
  const Places places = surface.is_mesh() ? places_on_mesh(surface, spacing_m, seed)
                                          : places_on_cloud(surface, spacing_m, seed);
  Samples samples;
  if (places.points.empty()) return samples;
  for (const std::uint32_t i : near_order(places.points))
    for (const float side : {1.0F, -1.0F}) {
      samples.points.push_back(places.points[i].cast<float>());
      samples.normals.push_back(side * places.normals[i]);
      samples.lifts_m.push_back(places.lifts_m[i]);
    }
  return samples;
}

}  // namespace arcbid
