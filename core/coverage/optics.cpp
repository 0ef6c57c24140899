// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/coverage/optics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace arcbid {

namespace {

constexpr double kDegree = std::numbers::pi / 180;

}  // namespace

Sensor narrowed(const Sensor& sensor, double normals_off_deg) {
  Sensor s = sensor;
  s.range_m -= std::min(0.2, 0.05 * s.range_m);
  s.least_range_m += s.least_range_m > 0 ? std::min(0.05, 0.05 * s.range_m) : 0;
  s.max_incidence_deg -= std::min(normals_off_deg, 0.2 * s.max_incidence_deg);
  if (s.horizontal_fov_deg < 360) s.horizontal_fov_deg -= std::min(2.0, 0.1 * s.horizontal_fov_deg);
  if (s.vertical_fov_deg < 180) s.vertical_fov_deg -= std::min(2.0, 0.1 * s.vertical_fov_deg);
  return s;
}

Pose pose_of(const Vec3& position_m, const Vec3& look) {
  Pose pose;
  pose.position_m = position_m.cast<float>();
  pose.forward = look.cast<float>();
  const float level = std::hypot(pose.forward.x(), pose.forward.y());
  pose.plumb = level < 1e-3F;
  pose.right = pose.plumb ? Vec3f(Vec3f::UnitX())
                          : Vec3f(pose.forward.y() / level, -pose.forward.x() / level, 0);
  pose.up = pose.right.cross(pose.forward);
  return pose;
}

Optics::Optics(const Sensor& s)
    : all_round_(s.all_round()),
      least_m2_(static_cast<float>(s.least_range_m * s.least_range_m)),
      range_m_(static_cast<float>(s.range_m)),
      most_m2_(range_m_ * range_m_),
      cos_(static_cast<float>(std::cos(s.max_incidence_deg * kDegree))),
      cos2_(cos_ * cos_),
      half_h_(static_cast<float>(s.horizontal_fov_deg * kDegree / 2)),
      half_v_(static_cast<float>(s.vertical_fov_deg * kDegree / 2)),
      lowest_(s.lowest_look_deg * kDegree),
      highest_(s.highest_look_deg * kDegree) {}

bool Optics::in_view(const Pose& pose, const Vec3f& point) const {
  if (all_round_) return true;
  const Vec3f way = point - pose.position_m;
  const float ahead = way.dot(pose.forward), beside = way.dot(pose.right), above = way.dot(pose.up);
  // Any heading may be meant: what lies in the image's inscribed cone is seen with all of them.
  if (pose.plumb) return std::atan2(std::hypot(beside, above), ahead) <= std::min(half_h_, half_v_);
  if (std::atan2(std::abs(beside), ahead) > half_h_) return false;
  // A flat image's edges are planes; those of one that goes round are cones.
  const bool flat = half_h_ < static_cast<float>(std::numbers::pi / 2);
  return std::atan2(std::abs(above), flat ? ahead : std::hypot(ahead, beside)) <= half_v_;
}

Vec3 Optics::aim(const Vec3& direction) const {
  const double level = std::hypot(direction.x(), direction.y());
  const double elevation = std::atan2(direction.z(), level);
  const double legal = std::clamp(elevation, lowest_, highest_);
  if (legal == elevation) return direction.normalized();
  const double x = level > 0 ? direction.x() / level : 1, y = level > 0 ? direction.y() / level : 0;
  return {std::cos(legal) * x, std::cos(legal) * y, std::sin(legal)};
}

}  // namespace arcbid
