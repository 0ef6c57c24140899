// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structure/ground.hpp"

#include <gmock/gmock.h>

#include "core/coverage/coverage_arcs.hpp"
#include "core/structure/parametric.hpp"

namespace arcbid {
namespace {

Structure bridge_cloud() {
  ParametricBridge b;
  b.length_m = 30;
  Structure cloud;
  cloud.points = surface_samples(generate(b), 0.25, 3);
  return cloud;
}

Structure with_ground(Structure cloud) {
  for (double x = -40; x <= 40; x += 0.5)
    for (double y = -25; y <= 25; y += 0.5)
      cloud.points.emplace_back(x, y, 0.1 * std::sin(x) * std::cos(y));
  return cloud;
}

TEST(Ground, IsToldFromTheStructure) {
  const Structure cloud = bridge_cloud();
  const auto split = without_ground(with_ground(cloud));
  ASSERT_TRUE(split);
  EXPECT_NEAR(split->ground_m, 0, 0.1);
  EXPECT_GT(split->structure.points.size(), 0.95 * cloud.points.size());
  for (const Vec3& p : split->structure.points) EXPECT_LE(std::abs(p.y()), 8);
}

TEST(Ground, IsNotSeenWhereThereIsNone) {
  EXPECT_FALSE(without_ground(bridge_cloud()));
  Structure slab;
  for (double x = 0; x < 20; x += 0.25)
    for (double y = 0; y < 20; y += 0.25) slab.points.emplace_back(x, y, 0);
  EXPECT_FALSE(without_ground(slab));
}

TEST(Ground, IsNotInspectedButSaidAndKeptClearOf) {
  CoverageSettings settings;
  settings.ground_clearance_m = 0;
  const Structure cloud = with_ground(bridge_cloud());
  const ArcPlan plan = coverage_arcs(cloud, settings);
  EXPECT_THAT(plan.warnings, testing::Contains(testing::HasSubstr("are the ground at z =")));
  for (const Arc& arc : plan.arcs)
    for (const Waypoint& w : arc.waypoints) {
      EXPECT_LE(std::abs(w.position_m.y()), 20);
      for (const Vec3& p : cloud.points) ASSERT_GE((p - w.position_m).norm(), settings.safety_m);
    }
  settings.ground_points = GroundPoints::keep;
  EXPECT_GT(coverage_arcs(cloud, settings).planned.samples, 1.5 * plan.planned.samples);
}

}  // namespace
}  // namespace arcbid
