// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structure/bridge_arcs.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"
#include "core/structure/parametric.hpp"
#include "tests/structure/arc_laws.hpp"

namespace arcbid {
namespace {

using testing::HasSubstr;

std::vector<Arc> of_kind(const ArcPlan& plan, ArcKind kind) {
  std::vector<Arc> arcs;
  for (const Arc& arc : plan.arcs)
    if (arc.kind == kind) arcs.push_back(arc);
  return arcs;
}

double length_variance(const std::vector<Arc>& arcs) {
  double sum = 0, squares = 0;
  for (const Arc& arc : arcs) {
    sum += length_m(arc.waypoints);
    squares += std::pow(length_m(arc.waypoints), 2);
  }
  const auto n = static_cast<double>(arcs.size());
  return squares / n - sum / n * sum / n;
}

class ParametricKinds : public testing::TestWithParam<BridgeKind> {};

TEST_P(ParametricKinds, KeepTheLawsAtTheDistancesOfTable1) {
  ParametricBridge bridge;
  bridge.kind = GetParam();
  for (const double spacing_m : {3.0, 4.0, 5.0}) {
    CoverageSettings settings;
    settings.spacing_m = spacing_m;
    const ArcPlan plan = bridge_arcs(generate(bridge), settings);
    expect_arc_laws(plan, generate(bridge), settings);
    for (const ArcKind kind : {ArcKind::outline, ArcKind::top_row, ArcKind::underside_row})
      EXPECT_FALSE(of_kind(plan, kind).empty()) << name(kind);
    EXPECT_GT(plan.within_reach, 0.95);
  }
}

INSTANTIATE_TEST_SUITE_P(All, ParametricKinds,
                         testing::Values(BridgeKind::girder, BridgeKind::arch, BridgeKind::towers));

TEST(BridgeArcs, RowsFlyOverTheDeckAndUnderTheGirders) {
  const ArcPlan plan =
      bridge_arcs(generate({}), {});  // deck 60 x 12 at 12 m, girders' bottom 9.5 m
  const std::vector<Arc> top = of_kind(plan, ArcKind::top_row);
  ASSERT_EQ(top.size(), 12u);  // 60 m in rows 5 m apart, across the deck
  std::vector<double> x;
  for (const Arc& row : top) {
    ASSERT_EQ(row.waypoints.size(), 3u);
    EXPECT_NEAR(length_m(row.waypoints), 8, 1e-6);
    for (const Waypoint& w : row.waypoints) {
      EXPECT_NEAR(w.position_m.z(), 16, 0.01);
      EXPECT_NEAR(w.position_m.x(), row.waypoints[0].position_m.x(), 1e-6);
    }
    x.push_back(row.waypoints[0].position_m.x());
  }
  std::sort(x.begin(), x.end());
  for (std::size_t i = 0; i < x.size(); ++i)
    EXPECT_NEAR(x[i], -27.5 + 5 * static_cast<double>(i), 1e-6);

  for (const Arc& row : of_kind(plan, ArcKind::underside_row))
    for (const Waypoint& w : row.waypoints) {
      EXPECT_NEAR(w.position_m.z(), 5.5, 0.3);  // it dips between girders, and beside piers
      for (const double pier : {-15.0, 0.0, 15.0})
        EXPECT_GT(std::abs(w.position_m.x() - pier), 1 + 2 - 0.01);
    }
}

TEST(BridgeArcs, OutlinesLookInwardFromTheStandoff) {
  const Structure tower = box_mesh({-3, -2, 0}, {3, 2, 40});
  const ArcPlan plan = bridge_arcs(tower, {});
  for (const Arc& arc : of_kind(plan, ArcKind::outline))
    for (const Waypoint& w : arc.waypoints) {
      const Vec3 nearest = w.position_m.cwiseMax(Vec3(-3, -2, 0)).cwiseMin(Vec3(3, 2, 40));
      EXPECT_GE((w.position_m - nearest).norm(), 4 - 0.05);
      EXPECT_LE((w.position_m - nearest).norm(), 4 * 1.02 + 0.05);
      EXPECT_NEAR(w.look.z(), 0, 1e-12);
      EXPECT_GT(w.look.dot((nearest - w.position_m).normalized()), 1 - 1e-6);
    }
  EXPECT_EQ(of_kind(plan, ArcKind::outline).size(), 8u);
  EXPECT_TRUE(of_kind(plan, ArcKind::underside_row).empty());  // it stands on the ground
}

TEST(BridgeArcs, RowsTurnWithTheBridge) {
  const double yaw = 0.6;
  const Vec3 along(std::cos(yaw), std::sin(yaw), 0);
  const Structure deck = box_mesh({-40, -5, 0}, {40, 5, 6}, yaw);
  const std::vector<Arc> rows = of_kind(bridge_arcs(deck, {}), ArcKind::top_row);
  EXPECT_EQ(rows.size(), 16u);
  for (const Arc& row : rows)
    for (const Waypoint& w : row.waypoints)
      EXPECT_NEAR((w.position_m - row.waypoints[0].position_m).dot(along), 0, 1e-6);
}

TEST(BridgeArcs, LongSideRowsMakeTheTaskSetUneven) {
  CoverageSettings long_side;
  long_side.rows = RowSide::long_side;
  const ArcPlan across = bridge_arcs(generate({}), {}),
                along = bridge_arcs(generate({}), long_side);
  const auto rows = [](const ArcPlan& p) { return of_kind(p, ArcKind::top_row); };
  EXPECT_EQ(rows(along).size(), 3u);
  EXPECT_NEAR(length_variance(rows(across)), 0, 1e-6);
  EXPECT_GT(length_variance(along.arcs), 1.2 * length_variance(across.arcs));
}

TEST(BridgeArcs, AStepHasRowsOverItsExposedPartOnly) {
  const Structure step =
      joined(box_mesh({-20, -10, 0}, {0, 10, 10}), box_mesh({0, -10, 0}, {20, 10, 20}));
  const ArcPlan plan = bridge_arcs(step, {});
  std::size_t low = 0, high = 0;
  for (const Arc& row : of_kind(plan, ArcKind::top_row))
    for (const Waypoint& w : row.waypoints) {
      const bool is_low = w.position_m.x() < 0;
      EXPECT_NEAR(w.position_m.z(), is_low ? 14 : 24, 0.05);
      ++(is_low ? low : high);
    }
  EXPECT_EQ(low, 16u);
  EXPECT_EQ(high, 16u);
}

TEST(BridgeArcs, AnOverhangHasRowsUnderIt) {
  const Structure mushroom =
      joined(box_mesh({-2, -2, 0}, {2, 2, 20}), box_mesh({-15, -15, 20}, {15, 15, 25}));
  const std::vector<Arc> under = of_kind(bridge_arcs(mushroom, {}), ArcKind::underside_row);
  ASSERT_FALSE(under.empty());
  for (const Arc& row : under)
    for (const Waypoint& w : row.waypoints)
      EXPECT_NEAR(w.position_m.z(), 16, 0.5);  // pushed aside by the stem
}

TEST(BridgeArcs, TheGroundCanBeGiven) {
  const Structure slab = box_mesh({-15, -15, 0}, {15, 15, 1});
  EXPECT_TRUE(of_kind(bridge_arcs(slab, {}), ArcKind::underside_row).empty());
  CoverageSettings settings;
  settings.ground_m = -20;
  const ArcPlan plan = bridge_arcs(slab, settings);
  expect_arc_laws(plan, slab, settings);
  for (const Arc& row : of_kind(plan, ArcKind::underside_row))
    EXPECT_NEAR(row.waypoints[0].position_m.z(), -4, 0.05);
  EXPECT_FALSE(of_kind(plan, ArcKind::underside_row).empty());
}

/// Up and side faces of the girder bridge, sampled by the test.
TEST(BridgeArcs, ReachTheOutsideOfAGirderBridge) {
  const Structure mesh = generate({});
  for (const double spacing_m : {3.0, 5.0}) {
    CoverageSettings settings;
    settings.spacing_m = spacing_m;
    const ArcPlan plan = bridge_arcs(mesh, settings);
    const NearPoints arcs(along_arcs(plan.arcs, 0.5), settings.standoff_m + spacing_m);
    std::size_t reached = 0, all = 0;
    for (const Vec3& p : surface_samples(mesh, 0.4, 99)) {
      const bool top = p.z() > 12 - 1e-9, side = std::abs(p.y()) > 6 - 1e-9;
      const bool pier = p.z() < 9.5 - 1e-9;
      if (!top && !side && !pier) continue;
      ++all;
      reached += arcs.distance_m(p) < settings.standoff_m + spacing_m;
    }
    EXPECT_GE(static_cast<double>(reached), 0.95 * static_cast<double>(all));
  }
}

TEST(BridgeArcs, AreTheSameBitForBit) {
  const Structure mesh = generate({});
  Structure cloud;
  cloud.points = surface_samples(mesh, 0.3, 5);
  for (const Structure& s : {mesh, cloud})
    EXPECT_EQ(digest(bridge_arcs(s, {}).arcs), digest(bridge_arcs(s, {}).arcs));
}

TEST(BridgeArcs, ACloudGivesNearlyTheMeshesArcs) {
  const Structure mesh = generate({});
  Structure cloud;
  cloud.points = surface_samples(mesh, 0.15, 5);
  const ArcPlan of_mesh = bridge_arcs(mesh, {}), of_cloud = bridge_arcs(cloud, {});
  expect_arc_laws(of_cloud, cloud, {});
  EXPECT_EQ(of_kind(of_cloud, ArcKind::top_row).size(), of_kind(of_mesh, ArcKind::top_row).size());
  EXPECT_NEAR(of_cloud.surface_m2, of_mesh.surface_m2, 0.5 * of_mesh.surface_m2);
}

TEST(BridgeArcs, SaysWhichSettingIsIllegal) {
  const auto message = [](auto change) -> std::string {
    CoverageSettings settings;
    change(settings);
    try {
      bridge_arcs(generate({}), settings);
    } catch (const InputError& e) {
      return e.what();
    }
    return "accepted";
  };
  EXPECT_EQ(message([](auto& s) { s.spacing_m = -1; }),
            "coverage.spacing_m: -1 is outside [0.01, 1000]");
  EXPECT_THAT(message([](auto& s) { s.standoff_m = std::nan(""); }), HasSubstr("standoff_m: nan"));
  EXPECT_THAT(message([](auto& s) { s.safety_m = 4; }), HasSubstr("at least 4.4 is legal"));
  EXPECT_THAT(message([](auto& s) { s.spacing_m = 0.01; }), HasSubstr("viewpoints"));
  EXPECT_THAT(message([](auto& s) { s.ground_m = INFINITY; }), HasSubstr("ground_m: inf"));
}

}  // namespace
}  // namespace arcbid
