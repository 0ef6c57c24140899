// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/coverage/surfels.hpp"

#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "core/coverage/parallel.hpp"

namespace arcbid {

namespace {

using Vec2f = Eigen::Vector2f;

constexpr std::size_t kNeighbours = 16;    // that give a normal
constexpr std::size_t kSpacingRank = 6;    // in a square lattice: the diagonal neighbour
constexpr float kOverlap = 1.1F;           // of spheres whose surface bends
constexpr float kLift = 1.15F;             // of the largest sphere near by
constexpr float kMost_m = 1;               // points farther apart are no surface
constexpr float kTouch = 1e-4F;            // for rounding
constexpr float kEnd = 1.5F, kRim = 0.7F;  // of the spacing: beyond the first the surface ends

/// Of every point its nearest, itself first.
class Neighbours {
 public:
  Neighbours(const std::vector<Vec3>& points, unsigned threads)
      : each_(std::min(kNeighbours, points.size())), found_(each_ * points.size()) {
    const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
    for (const Vec3& p : points) {
      const Vec3f f = p.cast<float>();
      cloud->push_back({f.x(), f.y(), f.z()});
      places_.push_back(f);
    }
    pcl::KdTreeFLANN<pcl::PointXYZ> tree;
    tree.setInputCloud(cloud);
    for_chunks(points.size(), 1024, threads, [&](std::size_t from, std::size_t to) {
      pcl::Indices found;
      std::vector<float> squared_m2;
      for (std::size_t i = from; i < to; ++i) {
        tree.nearestKSearch((*cloud)[i], static_cast<int>(each_), found, squared_m2);
        std::copy(found.begin(), found.end(), found_.begin() + offset(i));
      }
    });
  }
  std::span<const std::int32_t> of(std::size_t i) const {
    return std::span(found_).subspan(i * each_, each_);
  }
  const Vec3f& place(std::size_t i) const { return places_[i]; }
  std::vector<Vec3f> places_around(std::size_t i) const {
    std::vector<Vec3f> around;
    for (const std::int32_t n : of(i)) around.push_back(places_[static_cast<std::size_t>(n)]);
    return around;
  }

 private:
  std::ptrdiff_t offset(std::size_t i) const { return static_cast<std::ptrdiff_t>(i * each_); }
  std::size_t each_;
  std::vector<std::int32_t> found_;
  std::vector<Vec3f> places_;
};

/// The direction in which points spread least (of a line, any across it), and how far they do.
struct Fit {
  Vec3f normal = Vec3f::UnitZ();
  float spread_m = 0;
};

Fit fit_of(const std::vector<Vec3f>& points) {
  Vec3f mean = Vec3f::Zero();
  for (const Vec3f& p : points) mean += p;
  mean /= static_cast<float>(points.size());
  Eigen::Matrix3f spread = Eigen::Matrix3f::Zero();
  for (const Vec3f& p : points) spread += (p - mean) * (p - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver(spread);
  const Vec3f n = solver.eigenvectors().col(0);
  if (!n.allFinite() || n.norm() < 0.5F) return {};
  const float square = solver.eigenvalues()[0] / static_cast<float>(points.size());
  return {n.normalized(), std::sqrt(std::max(0.0F, square))};
}

/// At an edge the least spread is across neither face. So a point takes the normal of that one near
/// it whose neighbours are flattest, and in whose plane it lies.
Vec3f normal_at(std::size_t i, const Neighbours& neighbours, const std::vector<Fit>& fits) {
  const auto around = neighbours.of(i);
  float least_m = std::numeric_limits<float>::infinity();
  Vec3f best = Vec3f::UnitZ();
  for (const std::int32_t n : around) {
    const auto k = static_cast<std::size_t>(n);
    const Vec3f to = neighbours.place(i) - neighbours.place(k);
    const float off_m = fits[k].spread_m + std::abs(fits[k].normal.dot(to));
    if (off_m >= least_m) continue;
    least_m = off_m;
    best = fits[k].normal;
  }
  return best;
}

/// In a plane through zero, where neighbours are nearer to zero than `ends_m` tells them apart: the
/// farthest place that is as near to two of them as to zero, and to none nearer. 0: there is none.
float farthest_corner_m(const std::vector<Vec2f>& flat, float ends_m) {
  float most_m = 0;
  for (std::size_t i = 0; i < flat.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Vec2f &a = flat[i], &b = flat[j];
      const float twice = 2 * (a.x() * b.y() - a.y() * b.x());
      const float aa = a.squaredNorm(), bb = b.squaredNorm();
      const Vec2f corner = Vec2f(b.y() * aa - a.y() * bb, a.x() * bb - b.x() * aa) / twice;
      const float m = corner.norm();
      if (!(m > most_m && m < ends_m)) continue;
      const bool is_nearest = std::all_of(flat.begin(), flat.end(), [&](const Vec2f& other) {
        return (corner - other).norm() >= m - kTouch * ends_m;
      });
      if (is_nearest) most_m = m;
    }
  return most_m;
}

/// How large a sphere must be so that it and its neighbours' leave no hole however the points fell.
/// Where neighbours are far the surface ends.
float radius_m(const std::vector<Vec3f>& around, const Vec3f& normal) {
  const float rank_m = (around[std::min(kSpacingRank, around.size() - 1)] - around[0]).norm();
  const Vec3f x = normal.unitOrthogonal(), y = normal.cross(x);
  std::vector<Vec2f> flat;
  for (std::size_t n = 1; n < around.size(); ++n) {
    const Vec3f to = around[n] - around[0];
    const Vec2f in_plane(to.dot(x), to.dot(y));
    if (in_plane.norm() > to.norm() / 2) flat.push_back(in_plane);
  }
  return std::min(kMost_m,
                  std::max(kRim * rank_m, kOverlap * farthest_corner_m(flat, kEnd * rank_m)));
}

/// Over its own sphere and the neighbours' as well.
void lift(std::vector<Surfel>& surfels, const Neighbours& neighbours) {
  for (std::size_t i = 0; i < surfels.size(); ++i) {
    const auto around = neighbours.of(i);
    for (const std::int32_t n : around.first(std::min(kSpacingRank + 1, around.size())))
      surfels[i].lift_m =
          std::max(surfels[i].lift_m, kLift * surfels[static_cast<std::size_t>(n)].radius_m);
  }
}

}  // namespace

std::vector<Surfel> surfels_of(const std::vector<Vec3>& points, unsigned threads) {
  const Neighbours neighbours(points, threads);
  std::vector<Fit> fits(points.size());
  std::vector<Surfel> surfels(points.size());
  for_chunks(points.size(), 1024, threads, [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) fits[i] = fit_of(neighbours.places_around(i));
  });
  for_chunks(points.size(), 1024, threads, [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) {
      const std::vector<Vec3f> around = neighbours.places_around(i);
      const Vec3f normal = normal_at(i, neighbours, fits);
      surfels[i] = {around[0], normal, radius_m(around, normal), 0};
    }
  });
  lift(surfels, neighbours);
  return surfels;
}

}  // namespace arcbid
