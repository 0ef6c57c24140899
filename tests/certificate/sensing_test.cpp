// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/certificate/sensing.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace arcbid::certificate {
namespace {

Vec3 direction(double azimuth_deg, double elevation_deg) {
  const double a = azimuth_deg * std::numbers::pi / 180, e = elevation_deg * std::numbers::pi / 180;
  return {std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)};
}

/// A surface 5 m away in that direction, square to the line of sight.
bool shows(const Sensor& sensor, const Vec3& look, const Vec3& towards) {
  return Sensing(sensor).shows({1, 2, 3}, look, Vec3(1, 2, 3) + 5 * towards, -towards);
}

TEST(Sensing, Range) {
  const Sensing camera(camera_preset());
  const auto at = [&](double distance_m) {
    return camera.shows({0, 0, 0}, {1, 0, 0}, {distance_m, 0, 0}, {-1, 0, 0});
  };
  EXPECT_FALSE(at(0.49));
  EXPECT_TRUE(at(0.51));
  EXPECT_TRUE(at(7.99));
  EXPECT_FALSE(at(8.01));
}

TEST(Sensing, IncidenceAndSide) {
  const Sensing lidar(lidar_preset());
  const auto tilted = [&](double deg) {
    return lidar.shows({0, 0, 0}, {1, 0, 0}, {5, 0, 0}, -direction(deg, 0));
  };
  EXPECT_TRUE(tilted(69.9));
  EXPECT_FALSE(tilted(70.1));
  EXPECT_FALSE(tilted(180));
}

TEST(Sensing, EdgesOfACamerasView) {
  const Sensor camera = camera_preset();  // 70 by 55 degrees
  const Vec3 ahead(1, 0, 0);
  EXPECT_TRUE(shows(camera, ahead, direction(34.9, 0)));
  EXPECT_FALSE(shows(camera, ahead, direction(35.1, 0)));
  EXPECT_TRUE(shows(camera, ahead, direction(0, 27.4)));
  EXPECT_FALSE(shows(camera, ahead, direction(0, 27.6)));
  EXPECT_FALSE(shows(camera, ahead, direction(180, 0)));
  // The image is flat: off its middle line, the same elevation is nearer to the edge.
  EXPECT_FALSE(shows(camera, ahead, direction(34, 27.4)));
}

TEST(Sensing, TheImageIsLevel) {
  Sensor narrow = camera_preset();
  narrow.vertical_fov_deg = 10;
  const Vec3 look = direction(40, -30), right = look.cross(Vec3::UnitZ()).normalized();
  EXPECT_TRUE(shows(narrow, look, (look + 0.5 * right).normalized()));
  EXPECT_FALSE(shows(narrow, look, (look + 0.5 * right.cross(look)).normalized()));
}

TEST(Sensing, LookingStraightDownTheNarrowerAngleCounts) {
  const Vec3 down(0, 0, -1);
  EXPECT_TRUE(shows(camera_preset(), down, direction(0, -90 + 27.4)));
  EXPECT_FALSE(shows(camera_preset(), down, direction(0, -90 + 27.6)));
  EXPECT_FALSE(shows(camera_preset(), down, direction(90, -90 + 27.6)));
}

TEST(Sensing, AScannerAllRoundHasNoLook) {
  EXPECT_TRUE(shows(lidar_preset(), {1, 0, 0}, {-1, 0, 0}));
  Sensor flat = lidar_preset();
  flat.vertical_fov_deg = 30;
  EXPECT_TRUE(shows(flat, {1, 0, 0}, direction(140, 14.9)));
  EXPECT_FALSE(shows(flat, {1, 0, 0}, direction(140, 15.1)));
}

TEST(Sensing, TheGimbalsLimits) {
  Sensor camera = camera_preset();
  camera.lowest_look_deg = -30;
  camera.highest_look_deg = 20;
  const auto ahead = [&](double elevation) {
    return shows(camera, direction(0, elevation), direction(0, elevation));
  };
  EXPECT_TRUE(ahead(-30));
  EXPECT_FALSE(ahead(-30.1));
  EXPECT_TRUE(ahead(20));
  EXPECT_FALSE(ahead(20.1));
  const Sensing sensing(camera);
  EXPECT_TRUE(sensing.can_point(direction(0, -57.4)));
  EXPECT_FALSE(sensing.can_point(direction(0, -57.6)));
  EXPECT_FALSE(sensing.can_point(direction(0, 47.6)));
}

}  // namespace
}  // namespace arcbid::certificate
