// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structure/clearance.hpp"

#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <algorithm>

#include "core/base/error.hpp"

namespace arcbid {

namespace {

// Between two places of a segment this far apart that keep a distance r, the segment keeps
// r - kLeastStep_m / 2, for a distance is 1-Lipschitz.
constexpr double kLeastStep_m = 0.05;
constexpr int kMostPushes = 16;

}  // namespace

/// PCL's points are floats: they are kept relative to the first one, where a float is good to a
/// tenth of a millimetre at a kilometre, and only tell which point is nearest.
struct Clearance::Index {
  std::vector<Vec3> points;
  pcl::KdTreeFLANN<pcl::PointXYZ> tree;

  pcl::PointXYZ local(const Vec3& p) const {
    const Eigen::Vector3f q = (p - points.front()).cast<float>();
    return {q.x(), q.y(), q.z()};
  }
};

Clearance::Clearance(const std::vector<Vec3>& points, double required_m, double floor_m)
    : required_m_(required_m + kLeastStep_m / 2), floor_m_(floor_m) {
  check(!points.empty(), "clearance from at least one point");
  auto index = std::make_unique<Index>();
  index->points = points;
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  cloud->reserve(points.size());
  for (const Vec3& p : points) cloud->push_back(index->local(p));
  index->tree.setInputCloud(cloud);
  index_ = std::move(index);
}

Clearance::~Clearance() = default;

Vec3 Clearance::nearest(const Vec3& p) const {
  pcl::Indices found(1);
  std::vector<float> squared_m2(1);
  index_->tree.nearestKSearch(index_->local(p), 1, found, squared_m2);
  return index_->points[static_cast<std::size_t>(found.front())];
}

bool Clearance::clears(const Vec3& from, const Vec3& to) const {
  if (std::min(from.z(), to.z()) < floor_m_) return false;
  const double length_m = (to - from).norm();
  double at_m = 0;
  while (true) {
    const Vec3 p = at_m < length_m ? Vec3(from + at_m / length_m * (to - from)) : to;
    const double spare_m = distance_m(p) - required_m_;
    if (spare_m < 0) return false;
    if (at_m >= length_m) return true;
    at_m += std::max(spare_m, kLeastStep_m);
  }
}

std::optional<Vec3> Clearance::pushed_clear(const Vec3& p, double most_m) const {
  // Far enough that the chord of two pushed points, some half required_m_ apart, may be flown too.
  const double beyond_m = required_m_ / 20;
  Vec3 at = p;
  for (int push = 0; push <= kMostPushes; ++push) {
    at.z() = std::max(at.z(), floor_m_);
    if ((at - p).norm() > most_m) return std::nullopt;
    const Vec3 away = at - nearest(at);
    const double distance_m = away.norm();
    if (distance_m >= required_m_) return at;
    if (distance_m < 1e-9) return std::nullopt;
    at += away / distance_m * (required_m_ + beyond_m - distance_m);
  }
  return std::nullopt;
}

}  // namespace arcbid
