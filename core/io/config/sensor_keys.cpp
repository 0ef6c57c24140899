// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/config/make_key.hpp"

namespace arcbid::yaml {
namespace {

Sensor preset(SensorKind kind) {
  return kind == SensorKind::camera ? camera_preset() : lidar_preset();
}

Key<Sensor> kind_key() {
  const Kind<SensorKind> kind =
      choice<SensorKind>({{"lidar", SensorKind::lidar}, {"camera", SensorKind::camera}});
  return {.name = "kind",
          .legal = kind.legal,
          .meaning = "What it is: sets the sensor's other keys, where these are not given.",
          .read =
              [=](const Place& place, Sensor& sensor, Report& report) {
                SensorKind chosen = sensor.kind;
                kind.read(place, chosen, report);
                sensor = preset(chosen);
              },
          .print = [=](const Sensor& sensor) { return kind.print(sensor.kind); },
          .is_first = true};
}

}  // namespace

Keys<Sensor> sensor_keys() {
  using S = Sensor;
  return {
      kind_key(),
      key("range_m", &S::range_m, number<double>(0.3, 200),
          "Greatest distance at which it sees; more than `coverage.standoff_m`. Camera: 8."),
      key("least_range_m", &S::least_range_m, number<double>(0, 100),
          "Least distance at which it sees; less than `coverage.standoff_m`. Camera: 0.5."),
      key("max_incidence_deg", &S::max_incidence_deg, number<double>(1, 89),
          "Greatest angle between the line of sight and the surface's normal."),
      key("horizontal_fov_deg", &S::horizontal_fov_deg, number<double>(1, 360),
          "Width of the field of view, the full angle. Camera: 70, and less than 180."),
      key("vertical_fov_deg", &S::vertical_fov_deg, number<double>(1, 180),
          "Height of the field of view, the full angle. Camera: 55, and less than 180."),
      key("lowest_look_deg", &S::lowest_look_deg, number<double>(-90, 90),
          "Lowest elevation over the horizon to which the gimbal can turn."),
      key("highest_look_deg", &S::highest_look_deg, number<double>(-90, 90),
          "Highest elevation to which the gimbal can turn; not below the lowest."),
  };
}

}  // namespace arcbid::yaml
