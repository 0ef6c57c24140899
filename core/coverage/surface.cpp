// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/coverage/surface.hpp"

#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/coverage/parallel.hpp"
#include "core/structure/voxels.hpp"

namespace arcbid {

namespace {

constexpr float kMeshLift_m = 0.01F;  // far less than any member is thick
constexpr double kSurfel_m = 0.15;    // between surfels where the cloud is dense
constexpr std::size_t kMostSurfels = 600'000;
constexpr int kNeighbours = 16;            // that give a normal
constexpr std::size_t kSpacingRank = 6;    // in a square lattice: the diagonal neighbour
constexpr int kWays = 16;                  // in which the neighbours must meet a disc
constexpr float kOverlap = 1.5F;           // corners lie between the directions that are tried
constexpr float kEnd = 1.5F, kRim = 0.6F;  // of the spacing: beyond the first the surface ends

/// The direction in which the points spread least; of a line, any across it.
Vec3f normal_of(const std::vector<Vec3f>& points) {
  Vec3f mean = Vec3f::Zero();
  for (const Vec3f& p : points) mean += p;
  mean /= static_cast<float>(points.size());
  Eigen::Matrix3f spread = Eigen::Matrix3f::Zero();
  for (const Vec3f& p : points) spread += (p - mean) * (p - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver(spread);
  const Vec3f n = solver.eigenvectors().col(0);
  return n.allFinite() && n.norm() > 0.5F ? Vec3f(n.normalized()) : Vec3f::UnitZ();
}

/// How far a disc must reach so that it and its neighbours' leave no hole: to the farthest corner
/// of the part of the plane that is nearer to it than to any neighbour. Where neighbours are far
/// the surface ends.
float closing_m(const std::vector<Vec3f>& around, const Vec3f& normal, float spacing_m) {
  const Vec3f x = normal.unitOrthogonal(), y = normal.cross(x);
  float most_m = 0;
  for (int k = 0; k < kWays; ++k) {
    const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(k) / kWays;
    const Vec3f way = std::cos(angle) * x + std::sin(angle) * y;
    float least_m = kEnd * spacing_m;
    for (const Vec3f& p : around) {
      const Vec3f to = p - around.front();
      const float along = to.dot(way);
      if (along > 0) least_m = std::min(least_m, to.squaredNorm() / (2 * along));
    }
    most_m = std::max(most_m, least_m < kEnd * spacing_m ? kOverlap * least_m : kRim * spacing_m);
  }
  return most_m;
}

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

/// Points with PCA normals, and discs just wide enough to close the gaps to their neighbours.
std::vector<Surfel> surfels_of(const std::vector<Vec3>& points, unsigned threads) {
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (const Vec3& p : points) {
    const Vec3f f = p.cast<float>();
    cloud->push_back({f.x(), f.y(), f.z()});
  }
  pcl::KdTreeFLANN<pcl::PointXYZ> tree;
  tree.setInputCloud(cloud);
  const int k = std::min<int>(kNeighbours, static_cast<int>(points.size()));
  std::vector<Surfel> surfels(points.size());
  for_chunks(points.size(), 1024, threads, [&](std::size_t from, std::size_t to) {
    pcl::Indices found;
    std::vector<float> squared_m2;
    std::vector<Vec3f> around;
    for (std::size_t i = from; i < to; ++i) {
      tree.nearestKSearch((*cloud)[i], k, found, squared_m2);
      around.clear();
      for (const auto n : found)
        around.push_back((*cloud)[static_cast<std::size_t>(n)].getVector3fMap());
      const float rank_m = std::sqrt(squared_m2[std::min(kSpacingRank, squared_m2.size() - 1)]);
      const Vec3f normal = normal_of(around);
      surfels[i] = {around.front(), normal, closing_m(around, normal, rank_m)};
    }
  });
  return surfels;
}

/// Where a cloud is much thinner than elsewhere its discs would hide what is behind: they grow no
/// larger than twice the median.
float limit_radii(std::vector<Surfel>& surfels) {
  std::vector<float> radii;
  for (const Surfel& s : surfels) radii.push_back(s.radius_m);
  const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
  std::nth_element(radii.begin(), middle, radii.end());
  for (Surfel& s : surfels) s.radius_m = std::clamp(s.radius_m, *middle / 2, 2 * *middle);
  return *middle;
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
  s.lift_m = kMeshLift_m;
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
  const float radius_m = limit_radii(s.surfels);
  s.lift_m = s.skip_m = 0.5F * radius_m;
  return s;
}

}  // namespace arcbid
