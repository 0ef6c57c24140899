// SPDX-License-Identifier: GPL-3.0-or-later
// Legs: safe by exact distances, as long as said, the same for everybody, and not much too long.
#include <gtest/gtest.h>

#include <bit>

#include "core/structure/parametric.hpp"
#include "tests/airspace/scenes.hpp"

namespace arcbid {
namespace {

class RandomLegs : public testing::TestWithParam<std::uint64_t> {
 protected:
  RandomLegs() : random(GetParam()), scene(some_boxes(random)) {
    for (int n = 0; n < 14; ++n) places.push_back(scene.free_place(random));
    for (int n = 0; n < 2; ++n)
      places.push_back(Vec3(real(random, -60, -50), real(random, -30, 30), 0));  // homes
  }
  Random random;
  Site scene;
  std::vector<Vec3> places;
};

std::uint64_t bits(double x) {
  return std::bit_cast<std::uint64_t>(x);
}

TEST_P(RandomLegs, KeepTheSafetyDistanceAllTheWay) {
  const ObstacleTransit transit(scene.airspace, scene.arcs, places);
  std::size_t bent = 0;
  for (const Vec3& from : places)
    for (const Vec3& to : places) {
      if (from == to) continue;
      const auto way = transit.way(from, to);
      ASSERT_EQ(way.front(), from);
      ASSERT_EQ(way.back(), to);
      bent += way.size() > 2;
      ASSERT_GE(scene.least_m(way, 0.25), scene.settings.safety_m);
      for (std::size_t n = 1; n + 1 < way.size(); ++n) ASSERT_GE(way[n].z(), 3 - 1e-9);
    }
  EXPECT_GT(bent, 0u);
}

TEST_P(RandomLegs, AreAsLongAsSaidAndTheSameBack) {
  const ObstacleTransit transit(scene.airspace, scene.arcs, places);
  const ObstacleTransit nothing_known(scene.airspace, scene.arcs, {});
  for (const Vec3& from : places)
    for (const Vec3& to : places) {
      const double length = transit.length_m(from, to);
      ASSERT_EQ(bits(length), bits(transit.length_m(to, from)));
      ASSERT_EQ(bits(length), bits(way_length_m(transit.way(from, to))));
      ASSERT_EQ(bits(length), bits(nothing_known.length_m(from, to)));
      ASSERT_GE(length, (to - from).norm() * (1 - 1e-12));
    }
}

TEST_P(RandomLegs, AreTheSameWithOneThreadAndTwoAndInAnyOrder) {
  const ObstacleTransit one(scene.airspace, scene.arcs, places, 1);
  std::vector<Vec3> shuffled(places.rbegin(), places.rend());
  shuffled.push_back(places[7]);  // twice
  const ObstacleTransit two(scene.airspace, scene.arcs, shuffled, 2);
  for (const Vec3& from : places)
    for (const Vec3& to : places) {
      ASSERT_EQ(bits(one.length_m(from, to)), bits(two.length_m(from, to)));
      ASSERT_EQ(one.way(from, to), two.way(from, to));
    }
}

/// A detour over a third place is never much shorter: at most 5 % and half a cell.
TEST_P(RandomLegs, ObeyTheTriangleInequalityButForALittle) {
  const ObstacleTransit transit(scene.airspace, scene.arcs, places);
  for (const Vec3& a : places)
    for (const Vec3& b : places)
      for (const Vec3& c : places)
        ASSERT_LE(transit.length_m(a, b),
                  (transit.length_m(a, c) + transit.length_m(c, b)) * 1.05 + 0.25);
}

TEST_P(RandomLegs, AreLookedUpAsTheyAreAsked) {
  const ObstacleTransit transit(scene.airspace, scene.arcs, places);
  Points points;
  for (const Vec3& p : places) points.push_back(p, transit.place(p));
  points.push_back(Vec3(-30, -30, 9));  // one that is not known
  points.insert(0, places[5]);          // and one that does not carry its number
  std::vector<double> there(points.size()), back(points.size());
  for (const Vec3& from : {places[3], Vec3(-28, 31, 12)}) {
    transit.lengths_m(from, points, there.data());
    transit.lengths_m(points, from, back.data());
    for (std::size_t n = 0; n < points.size(); ++n) {
      ASSERT_EQ(bits(there[n]), bits(transit.length_m(from, points.at(n))));
      ASSERT_EQ(bits(back[n]), bits(there[n]));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomLegs, testing::Range<std::uint64_t>(1, 13));

double length_m(const Site& scene, const Vec3& from, const Vec3& to) {
  const std::vector<Vec3> places{from, to};
  const ObstacleTransit transit(scene.airspace, scene.arcs, places);
  EXPECT_GE(scene.least_m(transit.way(from, to), 0.05), scene.settings.safety_m);
  return transit.length_m(from, to);
}

TEST(Leg, IsStraightWhereThatIsFree) {
  const Site scene(box_mesh(Vec3(0, 0, 0), Vec3(30, 1, 40)));
  const Vec3 from(-5, -10, 5), to(-5, 10, 8);
  EXPECT_EQ(length_m(scene, from, to), (to - from).norm());
}

/// The wall inflated by the safety distance: the shortest way touches its rounded edge.
TEST(Leg, GoesAroundAWall) {
  const Site scene(box_mesh(Vec3(0, 0, 0), Vec3(30, 1, 40)));
  const double around = length_m(scene, Vec3(3, -4, 10), Vec3(3, 5, 10));
  // Over a corner 2 m from the wall's edge; the model's is up to 0.5 m farther out.
  EXPECT_GT(around, 2 * std::hypot(5, 2) + 5);
  EXPECT_LT(around, 17.6);
}

TEST(Leg, GoesOverALowWall) {
  const Site scene(box_mesh(Vec3(0, 0, 0), Vec3(60, 1, 10)));
  const Vec3 from(30, -4, 10), to(30, 5, 10);
  const std::vector<Vec3> places{from, to};
  const ObstacleTransit transit(scene.airspace, scene.arcs, places);
  double top = 0;
  for (const Vec3& p : transit.way(from, to)) top = std::max(top, p.z());
  EXPECT_GT(top, 12);
  EXPECT_LT(top, 13.6);
  EXPECT_LT(length_m(scene, from, to), 13.5);
}

TEST(Leg, GoesThroughAPortal) {
  const Structure portal = joined(
      joined(box_mesh(Vec3(-40, 0, 0), Vec3(-4, 1, 60)), box_mesh(Vec3(4, 0, 0), Vec3(40, 1, 60))),
      box_mesh(Vec3(-4, 0, 14), Vec3(4, 1, 60)));
  const Site scene(portal);
  EXPECT_LT(length_m(scene, Vec3(15, -6, 8), Vec3(15, 7, 8)), 35);
}

TEST(Leg, IntoTheBoxFromAHomeFarAway) {
  const Site scene(box_mesh(Vec3(0, 0, 0), Vec3(30, 1, 40)));
  const Vec3 home(15, 300, 0), behind(15, -4, 10);
  EXPECT_GE(length_m(scene, home, behind), 315);
  EXPECT_LT(length_m(scene, home, behind), 326);
}

TEST(Leg, BetweenHomesRisesToTheFloor) {
  const Site scene(box_mesh(Vec3(0, 0, 0), Vec3(30, 1, 40)));
  EXPECT_EQ(length_m(scene, Vec3(0, -20, 0), Vec3(30, -20, 1)), 3 + std::hypot(30, 0) + 2);
}

TEST(Leg, ToTheSamePointIsNothing) {
  const Site scene(box_mesh(Vec3(0, 0, 0), Vec3(30, 1, 40)));
  EXPECT_EQ(length_m(scene, Vec3(0, -20, 9), Vec3(0, -20, 9)), 0);
}

TEST(Leg, IntoASealedBoxThereIsNone) {
  const Site scene(sealed_box());
  const std::vector<Vec3> places{Vec3(8, 8, 13), Vec3(-10, 8, 13)};
  const ObstacleTransit transit(scene.airspace, scene.arcs, places);
  ASSERT_EQ(transit.closed_in(), std::vector<Vec3>{places[0]});
}

/// Through a room's only door, which no straight line of the lattice need hit.
TEST(Leg, FindsTheOnlyOpening) {
  Structure room = sealed_box();
  room.triangles.resize(room.triangles.size() - 12);
  room = joined(room, joined(box_mesh(Vec3(0, 0, 20), Vec3(16, 5, 21)),
                             box_mesh(Vec3(0, 10.4, 20), Vec3(16, 16, 21))));
  const Site scene(room);
  ASSERT_TRUE(scene.grid.free(Vec3(8, 8, 13)));
  EXPECT_LT(length_m(scene, Vec3(8, 8, 13), Vec3(-6, 8, 13)), 40);
}

}  // namespace
}  // namespace arcbid
