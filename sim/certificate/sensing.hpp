// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/arcs/arc.hpp"
#include "core/structure/sensor.hpp"

namespace arcbid::certificate {

/// A sensor's limits, ready to be asked. Sight lines are another matter.
class Sensing {
 public:
  explicit Sensing(const Sensor& sensor);

  /// Whether a sensor at `from` that points along `look` shows the side of a surface at `at` to
  /// which `normal` points. A look that the gimbal cannot take shows nothing.
  bool shows(const Vec3& from, const Vec3& look, const Vec3& at, const Vec3& normal) const;
  bool in_range(double distance_m) const {
    return distance_m >= sensor_.least_range_m && distance_m <= sensor_.range_m;
  }
  /// Whether some look that the gimbal can take has a direction (a unit vector from the sensor) in
  /// the middle of the image's width.
  bool can_point(const Vec3& direction) const;
  double least_cosine() const { return least_cosine_; }
  const Sensor& sensor() const { return sensor_; }

 private:
  bool in_view(const Vec3& look, const Vec3& direction) const;

  Sensor sensor_;
  double least_cosine_;  ///< of the angle off the surface's normal
};

}  // namespace arcbid::certificate
