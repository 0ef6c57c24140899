// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace arcbid {

enum class SensorKind : std::uint8_t { lidar, camera };

/// What a drone sees from a waypoint. A surface point is seen when it lies in range, in the field
/// of view, on the side that the surface shows, at most max_incidence off its normal, and nothing
/// is in between. The sensor hangs in a gimbal: it points along a waypoint's look, whose elevation
/// the gimbal limits; its image is level (no roll). Degrees, metres.
struct Sensor {
  SensorKind kind = SensorKind::lidar;
  double least_range_m = 0.0;
  double range_m = 8.0;
  double max_incidence_deg = 70.0;
  double horizontal_fov_deg = 360.0;  ///< full angle; 360 with 180: all round, looks do not matter
  double vertical_fov_deg = 180.0;    ///< full angle
  double lowest_look_deg = -90.0;     ///< of the gimbal; elevation over the horizon
  double highest_look_deg = 90.0;

  bool all_round() const { return horizontal_fov_deg >= 360 && vertical_fov_deg >= 180; }
};

/// A spinning lidar on a gimbal that sees all round, and a camera such as inspection drones carry.
constexpr Sensor lidar_preset() {
  return {};
}
constexpr Sensor camera_preset() {
  return {SensorKind::camera, 0.5, 8.0, 70.0, 70.0, 55.0, -90.0, 90.0};
}

}  // namespace arcbid
