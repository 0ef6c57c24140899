// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structure/hull.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace arcbid {
namespace {

double signed_area_m2(const Ring& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i)
    sum += cross(ring[i], ring[(i + 1) % ring.size()]) / 2;
  return sum;
}

std::vector<Vec3> square(double x, double y, double side) {
  std::vector<Vec3> points;
  for (double i = 0; i <= 10; ++i)
    for (double j = 0; j <= 10; ++j) points.emplace_back(x + i / 10 * side, y + j / 10 * side, i);
  return points;
}

std::vector<Vec3> squares(double gap) {
  std::vector<Vec3> both = square(0, 0, 2);
  const std::vector<Vec3> other = square(2 + gap, 0, 2);
  both.insert(both.end(), other.begin(), other.end());
  return both;
}

TEST(Clusters, PartWhereTheGapIsWiderThanAsked) {
  EXPECT_EQ(clustered_hulls(squares(3.9), 4, 0.1).size(), 1u);
  const std::vector<Hull> two = clustered_hulls(squares(4.3), 4, 0.1);
  ASSERT_EQ(two.size(), 2u);
  EXPECT_EQ(two[0].ring.size(), 4u);
  EXPECT_EQ(two[0].members.size(), 121u);
  EXPECT_NEAR(signed_area_m2(two[1].ring), 4, 1e-12);
}

TEST(Clusters, OfASpotAndOfALine) {
  EXPECT_EQ(clustered_hulls({{1, 1, 0}, {1, 1, 5}}, 4, 0.1).at(0).ring.size(), 1u);
  EXPECT_EQ(clustered_hulls({{0, 0, 0}, {1, 1, 0}, {2, 2, 0}}, 4, 0.1).at(0).ring.size(), 2u);
  EXPECT_TRUE(clustered_hulls({}, 4, 0.1).empty());
}

TEST(Offset, KeepsItsDistanceAndRoundsCorners) {
  for (const double yaw : {0.0, 0.3, 1.0}) {
    const Vec2 u(std::cos(yaw), std::sin(yaw)), v(-u.y(), u.x());
    const Hull hull{{Vec2(0, 0), 6 * u, 6 * u + 2 * v, 2 * v}, {}};
    const std::vector<Ring> outline = offset_outlines({hull}, 4);
    ASSERT_EQ(outline.size(), 1u);
    for (const Vec2& p : outline[0]) {
      EXPECT_GE((p - nearest_on(hull.ring, p)).norm(), 4 - 1e-9);
      EXPECT_LE((p - nearest_on(hull.ring, p)).norm(), 4 * 1.02);
    }
    const double exact = 12 + 16 * 4 + 16 * M_PI;  // rectangle, its sides' strips, a circle
    EXPECT_NEAR(signed_area_m2(outline[0]), exact, 0.015 * exact);
  }
}

TEST(Offset, OverlappingOutlinesAreUnitedAndApartOnesAreNot) {
  const auto outlines = [](double gap) {
    return offset_outlines(clustered_hulls(squares(gap), 1, 0.1), 4);
  };
  const std::vector<Ring> apart = outlines(9), united = outlines(5);
  ASSERT_EQ(apart.size(), 2u);
  ASSERT_EQ(united.size(), 1u);
  EXPECT_LT(signed_area_m2(united[0]), 2 * signed_area_m2(apart[0]));
  EXPECT_GT(signed_area_m2(united[0]), signed_area_m2(apart[0]));
}

TEST(Offset, AHoleRunsClockwise) {
  std::vector<Hull> frame;  // four walls around a yard of 20 m
  frame.push_back({{Vec2(0, 0), Vec2(20, 0)}, {}});
  frame.push_back({{Vec2(20, 0), Vec2(20, 20)}, {}});
  frame.push_back({{Vec2(0, 20), Vec2(20, 20)}, {}});
  frame.push_back({{Vec2(0, 0), Vec2(0, 20)}, {}});
  const std::vector<Ring> outlines = offset_outlines(frame, 2);
  ASSERT_EQ(outlines.size(), 2u);
  EXPECT_GT(signed_area_m2(outlines[0]), 0);
  EXPECT_NEAR(signed_area_m2(outlines[1]), -16 * 16, 1e-6);
}

TEST(Rectangle, IsFoundWhateverWayTheHullIsTurned) {
  for (double yaw = 0; yaw < 3; yaw += 0.37) {
    const Vec2 u(std::cos(yaw), std::sin(yaw)), v(-u.y(), u.x());
    const Vec2 at(5, -7);
    const Rectangle r = smallest_rectangle({at, at + 9 * u, at + 9 * u + 3 * v, at + 3 * v});
    EXPECT_NEAR(r.extent_m.prod(), 27, 1e-9);
    EXPECT_NEAR((r.at(r.extent_m.x() / 2, r.extent_m.y() / 2) - at - 4.5 * u - 1.5 * v).norm(), 0,
                1e-9);
  }
  const Rectangle r = smallest_rectangle({Vec2(0, 0), Vec2(8, 6), Vec2(6.2, 8.4), Vec2(-1.8, 2.4)});
  EXPECT_NEAR(r.extent_m.maxCoeff(), 10, 1e-9);
  EXPECT_NEAR(r.extent_m.minCoeff(), 3, 1e-9);
  EXPECT_EQ(smallest_rectangle({Vec2(3, 4)}).extent_m, Vec2(0, 0));
  EXPECT_NEAR(smallest_rectangle({Vec2(0, 0), Vec2(3, 4)}).extent_m.x(), 5, 1e-12);
}

TEST(Contains, ConvexRings) {
  const Ring square{Vec2(0, 0), Vec2(2, 0), Vec2(2, 2), Vec2(0, 2)};
  EXPECT_TRUE(contains(square, {1, 1.9}));
  EXPECT_FALSE(contains(square, {1, 2.1}));
  EXPECT_FALSE(contains(square, {2, 1}));  // the edge is not inside
  EXPECT_FALSE(contains({Vec2(0, 0), Vec2(2, 0)}, {1, 0}));
}

}  // namespace
}  // namespace arcbid
