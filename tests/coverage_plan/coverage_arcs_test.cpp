// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/coverage/coverage_arcs.hpp"

#include <gtest/gtest.h>

#include <boost/random/uniform_real_distribution.hpp>
#include <random>

#include "core/coverage/flyable.hpp"
#include "core/structure/parametric.hpp"
#include "tests/coverage_plan/brute_force.hpp"
#include "tests/structure/arc_laws.hpp"

namespace arcbid {
namespace {

Structure bridge(BridgeKind kind) {
  ParametricBridge b;
  b.kind = kind;
  b.length_m = 40;
  return generate(b);
}

Structure moved(Structure s, const Vec3& by) {
  for (Vec3& p : s.points) p += by;
  return s;
}

double sum_m(const std::vector<Arc>& arcs) {
  double sum = 0;
  for (const Arc& arc : arcs) sum += length_m(arc.waypoints);
  return sum;
}

class Bridges : public testing::TestWithParam<BridgeKind> {};

TEST_P(Bridges, KeepTheirDistanceAndLeaveNothingOut) {
  const Structure mesh = bridge(GetParam());
  const CoverageSettings settings;
  const ArcPlan plan = coverage_arcs(mesh, settings);
  EXPECT_GE(BruteForce(mesh, settings).least_clearance_m(plan.arcs), settings.safety_m);
  EXPECT_EQ(plan.planned.covered, plan.planned.visible);
  EXPECT_GT(plan.planned.covered, plan.planned.covered_by_base);
}

TEST_P(Bridges, AreTheSameForAnyNumberOfThreads) {
  for (const Sensor& sensor : {lidar_preset(), camera_preset()}) {
    CoverageSettings settings;
    settings.sensor = sensor;
    settings.threads = 1;
    const Structure mesh = bridge(GetParam());
    const std::uint64_t one = digest(coverage_arcs(mesh, settings).arcs);
    settings.threads = 2;
    EXPECT_EQ(digest(coverage_arcs(mesh, settings).arcs), one);
  }
}

TEST_P(Bridges, WithoutFillingAndTrimmingAreThePapersArcs) {
  CoverageSettings settings;
  settings.fill = settings.trim = false;
  const Structure mesh = bridge(GetParam());
  EXPECT_EQ(digest(coverage_arcs(mesh, settings).arcs), digest(bridge_arcs(mesh, settings).arcs));
}

TEST_P(Bridges, AreShorterWhenTrimmed) {
  CoverageSettings settings;
  settings.trim = false;
  const Structure mesh = bridge(GetParam());
  const double filled_m = sum_m(coverage_arcs(mesh, settings).arcs);
  settings.trim = true;
  EXPECT_LT(sum_m(coverage_arcs(mesh, settings).arcs), filled_m);
}

INSTANTIATE_TEST_SUITE_P(All, Bridges,
                         testing::Values(BridgeKind::girder, BridgeKind::arch, BridgeKind::towers));

TEST(CoverageArcs, FarFromTheOriginAreAsGood) {
  const Structure mesh = bridge(BridgeKind::girder);
  const Vec3 far(450'000, -320'000, 900);
  const ArcPlan near = coverage_arcs(mesh, {}), away = coverage_arcs(moved(mesh, far), {});
  EXPECT_EQ(away.planned.covered, away.planned.visible);
  EXPECT_NEAR(static_cast<double>(away.planned.visible), near.planned.visible,
              0.01 * near.planned.visible);
}

TEST(CoverageArcs, OfPointsOnALineKeepTheirDistance) {
  Structure line;
  for (int k = 0; k < 50; ++k) line.points.emplace_back(0.4 * k, 0, 5);
  const ArcPlan plan = coverage_arcs(line, {});
  EXPECT_FALSE(plan.arcs.empty());
  for (const Vec3& p : along_arcs(plan.arcs, 0.1))
    for (const Vec3& q : line.points) ASSERT_GE((p - q).norm(), 2.0);
}

TEST(Scene, KnowsHowFarACloudIs) {
  std::mt19937 random(9);
  boost::random::uniform_real_distribution<double> uniform(-10, 10);
  Structure cloud;
  for (int k = 0; k < 300; ++k)
    cloud.points.emplace_back(uniform(random), uniform(random), uniform(random));
  const Surface surface = surface_of(cloud, {}, 2);
  const Scene scene(surface);
  for (int k = 0; k < 200; ++k) {
    const Vec3 p(uniform(random), uniform(random), uniform(random));
    double least = 1e9;
    for (const Vec3& q : cloud.points) least = std::min(least, (p - q).norm());
    EXPECT_NEAR(scene.distance_m(p - surface.origin_m, 30), least, 1e-9);
  }
}

TEST(Flyable, KnowsDistancesAndClosedRooms) {
  const Structure mesh = box_mesh({-6, -6, 0}, {6, 6, 12});  // room enough inside to fly
  const Surface surface = surface_of(mesh, {}, 2);
  const Scene scene(surface);
  const Flyable flyable(scene, surface, {2.0, -6, 8.0}, 2);
  const BruteForce brute(mesh, {});
  std::mt19937 random(3);
  boost::random::uniform_real_distribution<double> uniform(-13, 13);
  for (int k = 0; k < 500; ++k) {
    const Vec3 p(uniform(random), uniform(random), uniform(random));
    EXPECT_NEAR(scene.distance_m(p, 30), brute.distance_m(p + surface.origin_m), 1e-9);
    if (p.z() < -6) continue;
    const bool outside = p.cwiseAbs().maxCoeff() > 6;
    const double d = brute.distance_m(p + surface.origin_m);
    EXPECT_EQ(flyable.clears(p), d >= 2.004);
    if (std::abs(d - 2) > 0.1) {
      EXPECT_EQ(flyable.reaches(p), outside && d > 2) << p.transpose();
    }
  }
  EXPECT_FALSE(flyable.clears({-9, 0, 0}, {9, 0, 0}));
  EXPECT_TRUE(flyable.clears({-9, 9, 0}, {9, 9, 0}));
}

}  // namespace
}  // namespace arcbid
