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

using Vec2 = Eigen::Vector2d;

constexpr std::size_t neighbours_for_normal = 12, neighbour_for_radius = 6;
constexpr double least_share =
    0.7;                            // of the sixth neighbour's distance: balls of a lattice overlap
constexpr double ends_share = 1.5;  // of it: where the next point is farther the surface ends
constexpr double overlap = 1.1;     // for rounding, and where the surface bends
constexpr double most_m = 1;        // points farther apart are no surface
constexpr double over_share =
    1.15;  // of the largest ball near by: a line of sight begins above all

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
  if (found.size() > neighbours_for_normal + 1) found.resize(neighbours_for_normal + 1);
  return found;
}

/// A plane through a point's neighbourhood, and how badly it fits.
struct Plane {
  Vec3 normal = Vec3::UnitZ();
  double rough_m = 0;  ///< root mean square of the distances from it
};

Plane plane_of(const std::vector<Vec3>& points, const std::vector<Neighbour>& around) {
  Vec3 mean = Vec3::Zero();
  for (const Neighbour& n : around) mean += points[n.number];
  mean /= static_cast<double>(around.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Neighbour& n : around) {
    const Vec3 off = points[n.number] - mean;
    spread += off * off.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
  const Vec3 normal = solver.eigenvectors().col(0);
  if (!normal.allFinite() || normal.norm() < 0.5) return {};
  const double mean_square = solver.eigenvalues()[0] / static_cast<double>(around.size());
  return {normal, std::sqrt(std::max(0.0, mean_square))};
}

/// At an edge the plane through both faces is neither: a point takes the plane of that neighbour
/// which is flattest and which the point lies in.
Vec3 normal_at(const std::vector<Vec3>& points, const std::vector<Neighbour>& around,
               const std::vector<Plane>& planes) {
  const Vec3& here = points[around.front().number];
  const auto misfit = [&](const Neighbour& n) {
    const Plane& plane = planes[n.number];
    return plane.rough_m + std::abs(plane.normal.dot(here - points[n.number]));
  };
  const auto best =
      std::min_element(around.begin(), around.end(),
                       [&](const auto& a, const auto& b) { return misfit(a) < misfit(b); });
  return planes[best->number].normal;
}

/// What of a convex polygon around zero is nearer to zero than to `other`.
std::vector<Vec2> nearer_part(const std::vector<Vec2>& polygon, const Vec2& other) {
  const double limit = 0.5 * other.squaredNorm();
  std::vector<Vec2> part;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec2 &here = polygon[k], &next = polygon[(k + 1) % polygon.size()];
    const double in = limit - here.dot(other), next_in = limit - next.dot(other);
    if (in >= 0) part.push_back(here);
    if ((in >= 0) != (next_in >= 0)) part.push_back(here + in / (in - next_in) * (next - here));
  }
  return part;
}

/// How far a ball must reach to leave no hole however the points fell: to the farthest corner of
/// what, of its plane, is nearer to it than to any neighbour.
double radius_of(const std::vector<Vec3>& points, const std::vector<Neighbour>& around,
                 const Vec3& normal) {
  const double sixth_m = around[std::min(neighbour_for_radius, around.size() - 1)].distance_m;
  const double ends_m = ends_share * sixth_m;
  const Vec3 x = normal.unitOrthogonal(), y = normal.cross(x);
  std::vector<Vec2> cell{
      {ends_m, ends_m}, {-ends_m, ends_m}, {-ends_m, -ends_m}, {ends_m, -ends_m}};
  for (const Neighbour& n : around) {
    const Vec3 to = points[n.number] - points[around.front().number];
    const Vec2 flat(to.dot(x), to.dot(y));
    if (flat.norm() > 0.5 * n.distance_m) cell = nearer_part(cell, flat);
  }
  double radius_m = least_share * sixth_m;
  for (const Vec2& corner : cell)
    if (corner.norm() < ends_m) radius_m = std::max(radius_m, overlap * corner.norm());
  return std::min(most_m, radius_m);
}

/// What a point of the cloud stands for.
struct Patch {
  Vec3 normal;
  double radius_m = 0;  ///< of its ball, large enough to leave no gap to its neighbours'
  double over_m = 0;    ///< over the surface: out of its own and its neighbours' balls
};

std::vector<Patch> patches_at(const Structure& thinned, double voxel_m, unsigned threads) {
  const Distances tree(thinned);
  const std::vector<Vec3>& points = thinned.points;
  std::vector<std::vector<Neighbour>> around(points.size());
  std::vector<Plane> planes(points.size());
  std::vector<Patch> patches(points.size());
  in_chunks(points.size(), 256, threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t p = first; p < last; ++p) {
      around[p] = nearest(points, tree, points[p], 2.5 * voxel_m);
      planes[p] = plane_of(points, around[p]);
    }
  });
  in_chunks(points.size(), 256, threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t p = first; p < last; ++p) {
      const Vec3 normal = normal_at(points, around[p], planes);
      patches[p] = {normal, radius_of(points, around[p], normal)};
    }
  });
  for (std::size_t p = 0; p < points.size(); ++p)
    for (std::size_t n = 0; n < std::min(neighbour_for_radius + 1, around[p].size()); ++n)
      patches[p].over_m =
          std::max(patches[p].over_m, over_share * patches[around[p][n].number].radius_m);
  return patches;
}

}  // namespace

void sample_cloud(const Structure& cloud, const SurfaceSettings& settings, Surface& surface) {
  if (cloud.points.empty()) return;
  surface.spacing_m = settings.spacing_m;
  const double finer_m = 0.5 * settings.spacing_m, area_m2 = std::pow(settings.spacing_m, 2);
  Structure thinned;
  for (const std::uint32_t number : one_each_voxel(cloud.points, finer_m, settings.seed))
    thinned.points.push_back(cloud.points[number]);
  const std::vector<Patch> patches = patches_at(thinned, finer_m, settings.threads);
  for (std::size_t p = 0; p < patches.size(); ++p)
    surface.balls.push_back({thinned.points[p], patches[p].radius_m});
  for (const std::uint32_t number :
       one_each_voxel(thinned.points, settings.spacing_m, settings.seed + 1))
    surface.points.push_back(
        {thinned.points[number], patches[number].normal, area_m2, patches[number].over_m});
}

}  // namespace arcbid::certificate
