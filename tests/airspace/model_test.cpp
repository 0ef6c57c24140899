// SPDX-License-Identifier: GPL-3.0-or-later
// The model against exact distances: what it calls free is free, and not too little of it is.
#include <gtest/gtest.h>

#include <cmath>

#include "core/airspace/runs.hpp"
#include "core/structure/parametric.hpp"
#include "tests/airspace/scenes.hpp"

namespace arcbid {
namespace {

class RandomModel : public testing::TestWithParam<std::uint64_t> {};

TEST_P(RandomModel, FreeCellsKeepTheSafetyDistanceInEveryPoint) {
  Random random(GetParam());
  const Site scene(some_boxes(random));
  const Cell size = scene.grid.size();
  int looked_at = 0;
  for (int n = 0; n < 20'000; ++n) {
    const Cell c{boost::random::uniform_int_distribution<int>(0, size[0] - 1)(random),
                 boost::random::uniform_int_distribution<int>(0, size[1] - 1)(random),
                 boost::random::uniform_int_distribution<int>(0, size[2] - 1)(random)};
    if (!scene.grid.free(c)) continue;
    // The corners are farthest from what was asked about, the middle.
    Vec3 p = scene.grid.centre(c);
    for (int axis = 0; axis < 3; ++axis)
      p[axis] +=
          scene.grid.cell_m() * (real(random, 0, 1) < 0.7 ? (real(random, 0, 1) < 0.5 ? -0.5 : 0.5)
                                                          : real(random, -0.5, 0.5));
    ASSERT_GE(scene.distance_m(p), scene.settings.safety_m) << p.transpose();
    ASSERT_GE(p.z(), 3 - 1e-9);
    ++looked_at;
  }
  EXPECT_GT(looked_at, 1000);
}

/// Half a cell's diagonal twice, and what the points that stand for the surface cost.
TEST_P(RandomModel, WhatIsWellClearIsFree) {
  Random random(GetParam());
  const Site scene(some_boxes(random));
  const double clear_m = scene.settings.safety_m + 2 * 0.4331 + 0.1;
  const Vec3 low = scene.airspace.low_m, size = scene.grid.centre(scene.grid.size()) - low;
  int closed = 0;
  for (int n = 0; n < 5000; ++n) {
    const Vec3 p = low + Vec3(real(random, 0, 1) * size.x(), real(random, 0, 1) * size.y(),
                              real(random, 0, 1) * size.z());
    if (scene.grid.free(p) || scene.distance_m(p) < clear_m) continue;
    ++closed;  // a pocket among boxes is rightly not free
  }
  EXPECT_LT(closed, 250);
}

TEST_P(RandomModel, IsTheSameAgainAndSmall) {
  Random random(GetParam());
  const Structure boxes = some_boxes(random);
  const Site scene(boxes), again(boxes);
  EXPECT_EQ(digest(scene.airspace), digest(again.airspace));
  EXPECT_LT(scene.airspace.runs.size(), 40'000u);
  EXPECT_EQ(encode_runs(decode_runs(scene.airspace), scene.airspace.cells), scene.airspace.runs);
  EXPECT_EQ(unsound(scene.airspace), std::nullopt);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomModel, testing::Range<std::uint64_t>(1, 13));

TEST(Model, TheInsideOfASealedBoxIsNotFree) {
  const Site scene(sealed_box());
  ASSERT_GT(scene.distance_m(Vec3(8, 8, 13)), 6);
  EXPECT_FALSE(scene.grid.free(Vec3(8, 8, 13)));
  EXPECT_TRUE(scene.grid.free(Vec3(8, 8, 24.5)));
}

TEST(Model, AnOpenBoxIsFreeInside) {
  Structure open = sealed_box();
  // Without the triangles of the last box, the roof.
  open.triangles.resize(open.triangles.size() - 12);
  const Site scene(open);
  EXPECT_TRUE(scene.grid.free(Vec3(8, 8, 13)));
}

TEST(Model, NothingUnderTheFloorIsFreeAndAllOutsideIs) {
  const Site scene(box_mesh(Vec3(0, 0, 0), Vec3(10, 2, 10)));
  EXPECT_FALSE(scene.grid.free(Vec3(-6, 0, 2.99)));
  EXPECT_TRUE(scene.grid.free(Vec3(-6, 0, 3)));
  EXPECT_FALSE(scene.grid.free(Vec3(-600, 0, 2.99)));
  EXPECT_TRUE(scene.grid.free(Vec3(-600, 70, 3)));
  EXPECT_TRUE(scene.grid.free(Vec3(5, 1, 900)));
}

TEST(Model, PointsUnderTheFloorCountToo) {
  const Site scene(box_mesh(Vec3(0, 0, 0), Vec3(10, 10, 2)));  // its top is under the floor
  EXPECT_FALSE(scene.grid.free(Vec3(5, 5, 3.2)));
  EXPECT_TRUE(scene.grid.free(Vec3(5, 5, 5.2)));
}

TEST(Model, LargeStructuresGetLargerCells) {
  const Site scene(joined(box_mesh(Vec3(0, 0, 0), Vec3(1, 1, 90)),
                          box_mesh(Vec3(899, 299, 0), Vec3(900, 300, 90))));
  EXPECT_GT(scene.airspace.cell_m, 1);
  EXPECT_LE(scene.grid.number({0, 0, scene.grid.size()[2]}), 4'000'000u);
  EXPECT_FALSE(scene.grid.free(Vec3(0.5, 3, 50)));
  EXPECT_TRUE(scene.grid.free(Vec3(0.5, 6, 50)));
  EXPECT_TRUE(scene.grid.free(Vec3(450, 150, 50)));
}

TEST(Model, SizeOfABridge) {
  EXPECT_LT(Site(generate({})).airspace.runs.size(), 10'000u);
}

/// An arc in a shaft too narrow for free cells: 4.6 m wide, so its middle is 2.3 m from the walls.
struct Shaft {
  static Structure walls(bool roof) {
    Structure all;
    for (const double x : {0.0, 5.6})
      all = joined(all, box_mesh(Vec3(x, 0, 0), Vec3(x + 1, 20, 20)));
    for (const double y : {0.0, 19.0})
      all = joined(all, box_mesh(Vec3(1, y, 0), Vec3(5.6, y + 1, 20)));
    if (roof) all = joined(all, box_mesh(Vec3(0, 0, 20), Vec3(6.6, 20, 21)));
    return all;
  }
  static std::vector<Arc> arcs() {
    const Vec3 look = Vec3::UnitX();
    return {Arc{{0}, ArcKind::outline, {{Vec3(3.3, 5, 10), look}, {Vec3(3.3, 15, 10), look}}},
            Arc{{1}, ArcKind::outline, {{Vec3(-4, 5, 10), look}, {Vec3(-4, 15, 10), look}}}};
  }
};

TEST(Access, LeadsOutOfANarrowShaft) {
  Site scene(Shaft::walls(false));
  scene.arcs = Shaft::arcs();
  ASSERT_FALSE(scene.grid.free(Vec3(3.3, 5, 10)));
  const Airspace model = scene.surroundings.airspace(scene.arcs, scene.warnings);
  ASSERT_EQ(scene.arcs.size(), 2u);
  ASSERT_EQ(model.accesses.size(), 1u);
  const Access& access = model.accesses[0];
  EXPECT_EQ(access.arc.value, 0u);
  EXPECT_EQ(access.points.front().position_m, scene.arcs[0].waypoints[access.waypoint].position_m);
  EXPECT_TRUE(scene.grid.free(access.points.back().position_m));
  std::vector<Vec3> way;
  for (const AccessPoint& p : access.points) way.push_back(p.position_m);
  EXPECT_GE(scene.least_m(way), scene.settings.safety_m);
  const std::vector<Vec3> places{Vec3(3.3, 5, 10), Vec3(3.3, 12, 10), Vec3(-4, 5, 10)};
  const ObstacleTransit transit(model, scene.arcs, places);
  EXPECT_TRUE(transit.closed_in().empty());
  EXPECT_EQ(transit.length_m(places[0], places[1]), 7);  // along the arc
  for (const Vec3& from : places)
    EXPECT_GE(scene.least_m(transit.way(from, places[2])), scene.settings.safety_m);
}

/// As near as arcs may run, and nearer than the points that stand for the surface would allow.
TEST(Access, LeadsAsNearTheSurfaceAsArcsRun) {
  Site scene(box_mesh(Vec3(0, 0, 0), Vec3(1, 20, 20)));
  const Vec3 look = Vec3::UnitX();
  scene.arcs = {Arc{{0}, ArcKind::gap, {{Vec3(-2.01, 5, 10), look}, {Vec3(-2.01, 15, 10), look}}}};
  const Airspace model = scene.surroundings.airspace(scene.arcs, scene.warnings);
  ASSERT_EQ(model.accesses.size(), 1u);
  std::vector<Vec3> way;
  for (const AccessPoint& p : model.accesses[0].points) way.push_back(p.position_m);
  EXPECT_GE(scene.least_m(way), scene.settings.safety_m);
}

TEST(Access, LeadsAsNearACloudAsArcsRun) {
  Structure wall;
  for (double y = 0; y <= 20; y += 0.25)
    for (double z = 0; z <= 20; z += 0.25) wall.points.emplace_back(0, y, z);
  Site scene(wall);
  const Vec3 look = Vec3::UnitX();
  scene.arcs = {Arc{{0}, ArcKind::gap, {{Vec3(-2.01, 5, 10), look}, {Vec3(-2.01, 15, 10), look}}}};
  const Airspace model = scene.surroundings.airspace(scene.arcs, scene.warnings);
  ASSERT_EQ(model.accesses.size(), 1u);
  for (const AccessPoint& p : model.accesses[0].points) EXPECT_LT(p.position_m.x(), -2.0);
}

/// Rounding puts arcs that run on the floor a hair under it: they are left like any other.
TEST(Access, LeadsFromAHairUnderTheFloor) {
  Site scene(box_mesh(Vec3(0, 0, 0), Vec3(1, 20, 20)));
  const double z = std::nextafter(3.0, 0.0);
  const Vec3 look = Vec3::UnitX();
  scene.arcs = {Arc{{0}, ArcKind::gap, {{Vec3(-2.01, 5, z), look}, {Vec3(-2.01, 15, z), look}}}};
  const Airspace model = scene.surroundings.airspace(scene.arcs, scene.warnings);
  const std::vector<Vec3> places{Vec3(-2.01, 10, z), Vec3(9, 10, 4)};
  const ObstacleTransit transit(model, scene.arcs, places);
  EXPECT_TRUE(transit.closed_in().empty());
  EXPECT_GE(scene.least_m(transit.way(places[0], places[1])), scene.settings.safety_m);
}

TEST(Access, AnArcThatIsClosedInIsLeftOutAndSaidSo) {
  Site scene(Shaft::walls(true));
  scene.arcs = Shaft::arcs();
  const Airspace model = scene.surroundings.airspace(scene.arcs, scene.warnings);
  ASSERT_EQ(scene.arcs.size(), 1u);
  EXPECT_EQ(scene.arcs[0].id.value, 0u);
  EXPECT_EQ(scene.arcs[0].waypoints[0].position_m, Vec3(-4, 5, 10));
  EXPECT_TRUE(model.accesses.empty());
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_EQ(scene.warnings[0],
            "arc 0, 10.0 m long at (3.3, 5.0, 10.0), cannot be reached and is left out: the "
            "surface closes it in at the safety distance, but for passages narrower than 0.25 m");
}

TEST(Home, MustStandClearAndUnderAClearColumn) {
  const Site scene(joined(box_mesh(Vec3(0, 0, 8), Vec3(30, 10, 9)),    // a deck
                          box_mesh(Vec3(14, 4, 0), Vec3(16, 6, 8))));  // and its pier
  EXPECT_TRUE(scene.surroundings.clear_home(Vec3(-8, 5, 0), scene.airspace));
  EXPECT_TRUE(scene.surroundings.clear_home(Vec3(5, 5, 0), scene.airspace));
  EXPECT_FALSE(scene.surroundings.clear_home(Vec3(15, 7, 0), scene.airspace));
  EXPECT_FALSE(scene.surroundings.clear_home(Vec3(15, 5, 4), scene.airspace));
  EXPECT_FALSE(scene.surroundings.clear_home(Vec3(5, 5, 7), scene.airspace));
  EXPECT_TRUE(scene.surroundings.clear_home(Vec3(5, 5, 12), scene.airspace));
}

}  // namespace
}  // namespace arcbid
