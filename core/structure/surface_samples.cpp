// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_01.hpp>
#include <cmath>

#include "core/base/error.hpp"
#include "core/structure/structure.hpp"
#include "core/structure/triangle.hpp"
#include "core/structure/validate.hpp"
#include "core/structure/voxels.hpp"

namespace arcbid {

namespace {

constexpr double kMostSamples = 2e7;

/// A point of the triangle, uniform by area, from two uniform numbers in [0, 1).
Vec3 point_of(const Triangle& t, double u, double v) {
  const double root = std::sqrt(u);
  return (1 - root) * t.a + root * (1 - v) * t.b + root * v * t.c;
}

/// Stratified by cumulative area: sample k falls in the k-th of n equal shares of the surface.
std::vector<Vec3> sampled_by_area(const Structure& mesh, double spacing_m, std::uint64_t seed) {
  std::vector<double> area_up_to_m2;
  area_up_to_m2.reserve(mesh.triangles.size());
  double area_m2 = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    area_up_to_m2.push_back(area_m2 += area_of(triangle(mesh, t)));
  if (!(area_m2 > 0)) return {};

  const double wanted = std::max(1.0, std::round(area_m2 / (spacing_m * spacing_m)));
  if (wanted > kMostSamples)
    throw InputError(fmt::format(
        "surface samples {} m apart on {:.0f} m2 would number {:.0f}; at least {:.3g} m is legal "
        "(check the file's unit)",
        spacing_m, area_m2, wanted, std::sqrt(area_m2 / kMostSamples)));
  boost::random::mt19937_64 random(seed);
  boost::random::uniform_01<double> uniform;
  std::vector<Vec3> samples;
  samples.reserve(static_cast<std::size_t>(wanted));
  for (double k = 0; k < wanted; ++k) {
    const double share_m2 = (k + uniform(random)) / wanted * area_m2;
    const auto at = std::upper_bound(area_up_to_m2.begin(), area_up_to_m2.end() - 1, share_m2);
    const double u = uniform(random), v = uniform(random);
    samples.push_back(
        point_of(triangle(mesh, static_cast<std::size_t>(at - area_up_to_m2.begin())), u, v));
  }
  return samples;
}

}  // namespace

std::vector<Vec3> surface_samples(const Structure& structure, double spacing_m,
                                  std::uint64_t seed) {
  require_range("surface samples' spacing_m", spacing_m, 1e-3, 1e4);
  checked_bounds(structure);
  return structure.is_mesh() ? sampled_by_area(structure, spacing_m, seed)
                             : one_per_voxel(structure.points, spacing_m);
}

}  // namespace arcbid
