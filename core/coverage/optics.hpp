// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "core/coverage/surface.hpp"
#include "core/structure/sensor.hpp"

namespace arcbid {

/// A somewhat worse sensor: a plan made for it also serves samples between those that it was
/// planned with, and positions between those that it was reckoned from. `normals_off_deg`: how far
/// others may find the surface to lean from what is known of it.
Sensor narrowed(const Sensor& sensor, double normals_off_deg);

/// A place of the sensor and how its image lies there: level, so that only the look decides.
struct Pose {
  Vec3f position_m, forward, right, up;
  bool plumb = false;  ///< looks straight up or down: its heading is not known
};
Pose pose_of(const Vec3& position_m, const Vec3& look);

/// A sensor's limits, made ready for many questions.
class Optics {
 public:
  explicit Optics(const Sensor& sensor);

  /// Range, side and incidence.
  bool in_reach(const Vec3f& eye, const Vec3f& point, const Vec3f& normal) const {
    const Vec3f way = eye - point;
    const float square = way.squaredNorm();
    if (square > most_m2_ || square < least_m2_) return false;
    const float along = way.dot(normal);
    return along > 0 && along * along >= cos2_ * square;
  }
  /// Field of view.
  bool in_view(const Pose& pose, const Vec3f& point) const;

  /// The look, within the gimbal's limits, that has `direction` nearest to the image's middle.
  Vec3 aim(const Vec3& direction) const;

  bool all_round() const { return all_round_; }
  float range_m() const { return range_m_; }
  float least_m() const { return std::sqrt(least_m2_); }
  float cos_incidence() const { return cos_; }

 private:
  bool all_round_;
  float least_m2_, range_m_, most_m2_, cos_, cos2_, half_h_, half_v_;
  double lowest_, highest_;
};

}  // namespace arcbid
