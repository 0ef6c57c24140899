// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "sim/certificate/distances.hpp"
#include "sim/certificate/parallel.hpp"
#include "sim/certificate/surface.hpp"

namespace arcbid::certificate {
namespace {

constexpr std::size_t neighbours_for_normal = 12, neighbour_for_radius = 6;
constexpr double disc_share = 0.7;  // of the sixth neighbour's distance: discs of a lattice overlap

/// One point a voxel: the one whose number comes first when all are shuffled by the seed.
std::vector<std::uint32_t> one_each_voxel(const std::vector<Vec3>& points, double voxel_m,
                                          std::uint64_t seed) {
  struct Entry {
    std::array<std::int64_t, 3> voxel;
    std::uint64_t rank;
    std::uint32_t number;
    bool operator<(const Entry& other) const {
      return std::tie(voxel, rank, number) < std::tie(other.voxel, other.rank, other.number);
    }
  };
  Vec3 shift;
  for (int axis = 0; axis < 3; ++axis) shift[axis] = voxel_m * share_of(mixed(seed, axis));
  std::vector<Entry> entries(points.size());
  for (std::uint32_t p = 0; p < points.size(); ++p) {
    for (int axis = 0; axis < 3; ++axis)
      entries[p].voxel[axis] =
          static_cast<std::int64_t>(std::floor((points[p][axis] + shift[axis]) / voxel_m));
    entries[p].rank = mixed(seed, p + 3ull);
    entries[p].number = p;
  }
  std::sort(entries.begin(), entries.end());
  std::vector<std::uint32_t> picked;
  for (std::size_t e = 0; e < entries.size(); ++e)
    if (e == 0 || entries[e].voxel != entries[e - 1].voxel) picked.push_back(entries[e].number);
  return picked;
}

struct Neighbour {
  double distance_m;
  std::uint32_t number;
  bool operator<(const Neighbour& other) const {
    return std::tie(distance_m, number) < std::tie(other.distance_m, other.number);
  }
};

/// The nearest ones, itself first; the search widens until there are enough.
std::vector<Neighbour> nearest(const std::vector<Vec3>& points, const Distances& tree,
                               const Vec3& at, double first_try_m) {
  std::vector<Neighbour> found;
  for (int attempt = 0; attempt < 5 && found.size() <= neighbours_for_normal; ++attempt) {
    const double reach_m = first_try_m * (1 << attempt);
    found.clear();
    for (const std::uint32_t number : tree.near(at, reach_m))
      if (const double d = (points[number] - at).norm(); d <= reach_m) found.push_back({d, number});
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// Across the plane that fits the neighbourhood best.
Vec3 normal_of(const std::vector<Vec3>& points, const std::vector<Neighbour>& around) {
  Vec3 mean = Vec3::Zero();
  for (const Neighbour& n : around) mean += points[n.number];
  mean /= static_cast<double>(around.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Neighbour& n : around) {
    const Vec3 off = points[n.number] - mean;
    spread += off * off.transpose();
  }
  const Vec3 normal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(0);
  return normal.allFinite() && normal.norm() > 0.5 ? normal : Vec3(Vec3::UnitZ());
}

/// The disc of each point, large enough to leave no gap to its neighbours.
std::vector<Disc> discs_at(const Structure& thinned, double voxel_m, unsigned threads) {
  const Distances tree(thinned);
  std::vector<Disc> discs(thinned.points.size());
  in_chunks(discs.size(), 256, threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t d = first; d < last; ++d) {
      std::vector<Neighbour> around =
          nearest(thinned.points, tree, thinned.points[d], 2.5 * voxel_m);
      const std::size_t sixth = std::min(neighbour_for_radius, around.size() - 1);
      const double radius_m = disc_share * around[sixth].distance_m;
      discs[d] = {thinned.points[d], normal_of(thinned.points, around), radius_m};
    }
  });
  return discs;
}

}  // namespace

void sample_cloud(const Structure& cloud, const SurfaceSettings& settings, Surface& surface) {
  if (cloud.points.empty()) return;
  surface.spacing_m = settings.spacing_m;
  const double finer_m = 0.5 * settings.spacing_m;
  Structure thinned;
  for (const std::uint32_t number : one_each_voxel(cloud.points, finer_m, settings.seed))
    thinned.points.push_back(cloud.points[number]);
  surface.discs = discs_at(thinned, finer_m, settings.threads);
  for (const std::uint32_t number :
       one_each_voxel(thinned.points, settings.spacing_m, settings.seed + 1)) {
    const Disc& disc = surface.discs[number];
    // Neighbours' discs lean a little: what is as near as half a disc is the surface itself.
    surface.points.push_back(
        {disc.middle_m, disc.normal, settings.spacing_m * settings.spacing_m, 0.5 * disc.radius_m});
  }
}

}  // namespace arcbid::certificate
