// SPDX-License-Identifier: GPL-3.0-or-later
// What is covered, and why the rest is not: shapes whose answers are known.
#include <gtest/gtest.h>

#include <limits>

#include "tests/certificate/shapes.hpp"

namespace arcbid::certificate {
namespace {

using testing::add_box;
using testing::add_plate;
using testing::count;
using testing::Counted;
using testing::flown;
using testing::level_plate;
using testing::settings;

bool is_up(const SampleResult& sample) {
  return sample.normal.z() > 0.5;
}
bool is_down(const SampleResult& sample) {
  return sample.normal.z() < -0.5;
}
void expect_all(const Counted& counted) {
  EXPECT_GT(counted.all, 20u);
  EXPECT_EQ(counted.of_fate, counted.all);
}
/// All of a route far away: nothing is covered.
Flown elsewhere() {
  return flown({{1000, 0, 50}, {1001, 0, 50}});
}

TEST(Coverage, APlateSeenFromOneSide) {
  const Certificate c = certify(level_plate(5, 10), flown({{-5, 0, 14}, {5, 0, 14}}), settings());
  expect_all(count(c, Fate::covered, is_up));
  expect_all(count(c, Fate::missed, is_down));
  EXPECT_EQ(c.visible_samples, c.surface_samples);
  EXPECT_DOUBLE_EQ(c.coverage_of_visible(), 0.5);
  EXPECT_NEAR(c.surface_m2, 200, 1e-6);
  EXPECT_NEAR(c.metres_per_m2(), 0.1, 1e-6);
  EXPECT_DOUBLE_EQ(c.min_clearance_m(), 4);
  EXPECT_EQ(c.samples.size(), c.surface_samples);
}

TEST(Coverage, FlippedFacesChangeNothing) {
  Structure flipped = level_plate(5, 10);
  for (auto& triangle : flipped.triangles) std::swap(triangle[0], triangle[1]);
  const Certificate c = certify(flipped, flown({{-5, 0, 14}, {5, 0, 14}}), settings());
  expect_all(count(c, Fate::covered, is_up));
  expect_all(count(c, Fate::missed, is_down));
}

/// Far below, and far away: neither the ground nor the grid may heed it.
TEST(Coverage, VerticesThatNoTriangleUsesChangeNothing) {
  const Flown route = flown({{-5, 0, 14}, {5, 0, 14}});
  Settings how = settings();
  how.ground_m.reset();
  Structure mesh = level_plate(5, 10);
  const Certificate without = certify(mesh, route, how);
  mesh.points.emplace_back(9e5, -9e5, -700);
  mesh.points.emplace_back(0, std::numeric_limits<double>::quiet_NaN(), 0);
  const Certificate with = certify(mesh, route, how);
  EXPECT_EQ(with.floor_m, without.floor_m);
  EXPECT_EQ(with.grid_m, without.grid_m);
  EXPECT_EQ(with.fates, without.fates);
  EXPECT_EQ(with.ray_offset_m, without.ray_offset_m);
}

TEST(Coverage, AnOccludersShadow) {
  Structure mesh = level_plate(5, 10);
  add_plate(mesh, {-2, -2, 13}, {4, 0, 0}, {0, 4, 0});
  add_box(mesh, {-0.1, -0.1, 5}, {0.1, 0.1, 9});  // else the plate would be the ground
  const Certificate c = certify(mesh, flown({{0, 0, 17}, {0, 0, 17.001}}), settings());
  const auto edge = [](const SampleResult& s) {
    return std::max(std::abs(s.position_m.x()), std::abs(s.position_m.y()));
  };
  const auto is_lower = [](const SampleResult& s) {
    return is_up(s) && std::abs(s.position_m.z() - 10) < 0.5;
  };
  const Counted shadow =
      count(c, Fate::covered, [&](const SampleResult& s) { return is_lower(s) && edge(s) < 3.4; });
  EXPECT_GT(shadow.all, 100u);
  EXPECT_EQ(shadow.of_fate, 0u);
  const Counted light = count(c, Fate::covered, [&](const SampleResult& s) {
    return is_lower(s) && edge(s) > 3.52 && s.position_m.head<2>().norm() < 3.8;
  });
  EXPECT_GT(light.all, 3u);
  EXPECT_EQ(light.of_fate, light.all);
}

TEST(Coverage, TheInsideOfAClosedBox) {
  Structure mesh;
  add_box(mesh, {-1.5, -1.5, 10}, {1.5, 1.5, 13});
  const Certificate c = certify(mesh, elsewhere(), settings());
  const auto inside = [](const SampleResult& s) {
    return (s.position_m - Vec3(0, 0, 11.5)).dot(s.normal) < 0;
  };
  expect_all(count(c, Fate::occluded, inside));
  expect_all(count(c, Fate::missed, [&](const SampleResult& s) { return !inside(s); }));
}

TEST(Coverage, APocketThatHasNoWayOut) {
  Structure mesh;
  add_box(mesh, {-6, -6, 10}, {6, 6, 22});
  const Certificate c = certify(mesh, elsewhere(), settings());
  const auto inside = [](const SampleResult& s) {
    return (s.position_m - Vec3(0, 0, 16)).dot(s.normal) < 0;
  };
  expect_all(count(c, Fate::unreachable, inside));
}

TEST(Coverage, WhatIsTooCloseToTheGround) {
  const Certificate c = certify(level_plate(5, 2), elsewhere(), settings());
  const auto is_inner = [](const SampleResult& s) {
    return is_down(s) && std::max(std::abs(s.position_m.x()), std::abs(s.position_m.y())) < 3;
  };
  expect_all(count(c, Fate::too_close_to_the_ground, is_inner));
  expect_all(count(c, Fate::missed, is_up));
}

/// A ditch too narrow to fly in, and deeper than the range.
TEST(Coverage, WhatIsOutOfRange) {
  Structure mesh;
  add_plate(mesh, {-30, -1.5, 20}, {60, 0, 0}, {0, 3, 0});
  for (const double y : {-1.5, 1.5}) add_plate(mesh, {-30, y, 20}, {60, 0, 0}, {0, 0, 10});
  const Certificate c = certify(mesh, elsewhere(), settings());
  const Counted bottom = count(c, Fate::out_of_range, [](const SampleResult& s) {
    return is_up(s) && std::abs(s.position_m.x()) < 10;
  });
  EXPECT_GT(bottom.all, 100u);
  EXPECT_GE(bottom.of_fate, bottom.all * 98 / 100);
}

TEST(Coverage, WhatIsSeenAtTooFlatAnAngleOnly) {
  Structure mesh = level_plate(5, 10);
  add_plate(mesh, {-5, -5, 13}, {10, 0, 0}, {0, 10, 0});
  Settings s = settings();
  s.sensor.max_incidence_deg = 45;
  const Certificate c = certify(mesh, elsewhere(), s);
  expect_all(count(c, Fate::incidence, [](const SampleResult& sample) {
    return is_up(sample) && sample.position_m.z() < 11 &&
           std::max(std::abs(sample.position_m.x()), std::abs(sample.position_m.y())) < 1.5;
  }));
}

TEST(Coverage, WhatTheGimbalCannotPointAt) {
  Settings s = settings();
  s.sensor = camera_preset();
  s.sensor.lowest_look_deg = s.sensor.highest_look_deg = 0;
  s.sensor.vertical_fov_deg = 20;
  const Certificate c = certify(level_plate(5, 10), elsewhere(), s);
  expect_all(count(c, Fate::gimbal, is_up));
}

TEST(Coverage, AnArcThatNoRouteFlies) {
  Flown half = flown({{-5, 0, 14}, {5, 0, 14}});
  half.flights[0].legs[0].waypoints = elsewhere().arcs[0];
  const Certificate c = certify(level_plate(5, 10), half, settings());
  expect_all(count(c, Fate::not_assigned, is_up));
  EXPECT_EQ(c.covered_samples, 0u);
}

TEST(Coverage, ARouteThatIsCutCoversLess) {
  const Structure plate = level_plate(12, 10);
  const Certificate whole = certify(plate, flown({{-12, 0, 14}, {12, 0, 14}}), settings());
  const Certificate cut = certify(plate, flown({{-12, 0, 14}, {2, 0, 14}}), settings());
  EXPECT_GT(whole.covered_samples, cut.covered_samples + 500);
  EXPECT_GT(whole.redundancy.mean, 3);
  EXPECT_GE(whole.redundancy.least, 1u);
}

/// What is seen from where no drone may be is covered, and not visible for that.
TEST(Coverage, SeenFromTooNearOnly) {
  Structure mesh = level_plate(10, 10);
  add_plate(mesh, {-10, -10, 13}, {20, 0, 0}, {0, 20, 0});
  const Certificate c = certify(mesh, flown({{-10, 0, 11.5}, {10, 0, 11.5}}), settings());
  EXPECT_GT(c.covered_samples, c.covered_visible_samples);
  EXPECT_FALSE(c.keeps_clear());
  EXPECT_NEAR(c.min_clearance_m(), 1.5, 1e-9);
}

/// What is visible does not depend on what was flown: a place that is too near does not end the
/// search along its line.
TEST(Coverage, WhatIsInRangeFartherOut) {
  Settings how = settings();
  how.sensor.least_range_m = 3;
  how.sensor.max_incidence_deg = 40;
  const Certificate c = certify(level_plate(5, 10), elsewhere(), how);
  expect_all(count(c, Fate::missed, is_up));
}

TEST(Coverage, TheGroundIsNotToBeSeen) {
  Structure mesh;
  add_plate(mesh, {-20, -20, 0}, {40, 0, 0}, {0, 40, 0});
  add_box(mesh, {-2, -2, 0}, {2, 2, 8});
  Settings s = settings();
  s.ground_m.reset();
  const Certificate c = certify(mesh, elsewhere(), s);
  EXPECT_NEAR(static_cast<double>(c.ground_samples) * c.spacing_m * c.spacing_m, 2 * 1616, 20);
  EXPECT_NEAR(c.surface_m2, 2 * (4 * 32 + 16), 20);
  Structure without;
  add_box(without, {-2, -2, 0}, {2, 2, 8});
  EXPECT_EQ(certify(without, elsewhere(), s).ground_samples, 0u);
}

TEST(Coverage, ACloudWithNoise) {
  Structure cloud;
  std::uint64_t n = 0;
  for (double x = -5; x <= 5; x += 0.1)
    for (double y = -5; y <= 5; y += 0.1) {
      n = n * 6364136223846793005u + 1442695040888963407u;
      cloud.points.emplace_back(x, y, 10 + 0.02 * (static_cast<double>(n >> 40) / (1 << 24) - 0.5));
    }
  const Certificate c = certify(cloud, flown({{-5, 0, 14}, {5, 0, 14}}), settings());
  const Counted top = count(c, Fate::covered, is_up), bottom = count(c, Fate::covered, is_down);
  EXPECT_GT(top.all, 900u);
  EXPECT_EQ(top.of_fate, top.all);
  EXPECT_EQ(bottom.of_fate, 0u);
}

}  // namespace
}  // namespace arcbid::certificate
