// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/certificate/sensing.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace arcbid::certificate {
namespace {

constexpr double slack_deg = 1e-6;

double radians(double degrees) {
  return degrees * std::numbers::pi / 180;
}

/// Over the horizon, of a unit vector.
double elevation_deg(const Vec3& direction) {
  return std::asin(std::clamp(direction.z(), -1.0, 1.0)) * 180 / std::numbers::pi;
}

double angle_deg(double opposite, double adjacent) {
  return std::abs(std::atan2(opposite, adjacent)) * 180 / std::numbers::pi;
}

}  // namespace

Sensing::Sensing(const Sensor& sensor)
    : sensor_(sensor), least_cosine_(std::cos(radians(sensor.max_incidence_deg))) {}

bool Sensing::shows(const Vec3& from, const Vec3& look, const Vec3& at, const Vec3& normal) const {
  const Vec3 ray = at - from;
  const double distance_m = ray.norm();
  if (!in_range(distance_m) || -ray.dot(normal) < least_cosine_ * distance_m) return false;
  if (sensor_.all_round()) return true;
  const double elevation = elevation_deg(look);
  if (elevation < sensor_.lowest_look_deg - slack_deg ||
      elevation > sensor_.highest_look_deg + slack_deg)
    return false;
  return in_view(look, ray / distance_m);
}

/// A camera's image is flat and level: both angles are taken in the planes of its axes. A scanner
/// turns about its upright axis: the vertical angle is the beam's over the plane across that axis.
bool Sensing::in_view(const Vec3& look, const Vec3& direction) const {
  const double half_width = 0.5 * sensor_.horizontal_fov_deg + slack_deg,
               half_height = 0.5 * sensor_.vertical_fov_deg + slack_deg;
  const double ahead = look.dot(direction);
  Vec3 right = look.cross(Vec3::UnitZ());
  constexpr double upright = 0.02;  // closer to the vertical, no heading is level
  if (right.norm() < upright) {
    const double off = angle_deg((direction - ahead * look).norm(), ahead);
    return off <= std::min(half_width, half_height);
  }
  right.normalize();
  const double aside = right.dot(direction), above = right.cross(look).dot(direction);
  if (angle_deg(aside, ahead) > half_width) return false;
  if (sensor_.kind == SensorKind::camera) return angle_deg(above, ahead) <= half_height;
  return angle_deg(above, std::hypot(aside, ahead)) <= half_height;
}

bool Sensing::can_point(const Vec3& direction) const {
  if (sensor_.all_round()) return true;
  const double elevation = elevation_deg(direction), half = 0.5 * sensor_.vertical_fov_deg;
  return elevation >= sensor_.lowest_look_deg - half - slack_deg &&
         elevation <= sensor_.highest_look_deg + half + slack_deg;
}

}  // namespace arcbid::certificate
