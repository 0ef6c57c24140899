// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/certificate/geometry.hpp"

#include <gtest/gtest.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include "sim/certificate/distances.hpp"
#include "tests/certificate/shapes.hpp"

namespace arcbid::certificate {
namespace {

const Triangle flat{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};

TEST(Geometry, ALegOverTheFace) {
  const Approach found = approach({1, 1, 5}, {1, 1, 2}, flat);
  EXPECT_DOUBLE_EQ(found.distance_m, 2);
  EXPECT_DOUBLE_EQ(found.along, 1);
}

TEST(Geometry, ALegPastAnEdge) {
  const Approach found = approach({-3, -2, 0}, {7, -2, 0}, flat);
  EXPECT_DOUBLE_EQ(found.distance_m, 2);
  const Approach crossing = approach({2, -3, -5}, {2, -3, 5}, flat);
  EXPECT_DOUBLE_EQ(crossing.distance_m, 3);
  EXPECT_DOUBLE_EQ(crossing.along, 0.5);
}

TEST(Geometry, ALegPastACorner) {
  const Approach found = approach({5, -10, 0}, {5, 10, 0}, flat);
  EXPECT_DOUBLE_EQ(found.distance_m, 1);
  EXPECT_DOUBLE_EQ(found.along, 0.5);
}

TEST(Geometry, ALegThroughTheFace) {
  const Approach found = approach({1, 1, 3}, {1, 1, -1}, flat);
  EXPECT_EQ(found.distance_m, 0);
  EXPECT_DOUBLE_EQ(found.along, 0.75);
  EXPECT_GT(approach({3, 3, 3}, {3, 3, -1}, flat).distance_m, 1);
}

TEST(Geometry, TrianglesThatAreALineOrAPoint) {
  const Triangle line{Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(4, 0, 0)};
  EXPECT_DOUBLE_EQ(approach({3, -1, 2}, {3, 1, 2}, line).distance_m, 2);
  EXPECT_DOUBLE_EQ(distance_m({5, 0, 0}, line), 1);
  const Triangle point{Vec3(1, 1, 1), Vec3(1, 1, 1), Vec3(1, 1, 1)};
  EXPECT_DOUBLE_EQ(approach({0, 1, 1}, {0, 2, 1}, point).distance_m, 1);
}

/// No point of the leg is nearer than what is said of the leg, and the place said is that near.
TEST(Geometry, AgreesWithManyPointsOfTheLeg) {
  boost::random::mt19937_64 random(7);
  boost::random::uniform_real_distribution<double> within(-5, 5);
  const auto any = [&] {
    const double x = within(random), y = within(random);
    return Vec3(x, y, within(random));
  };
  for (int round = 0; round < 2000; ++round) {
    const Triangle triangle{any(), any(), any()};
    const Vec3 from = any(), to = any();
    const Approach found = approach(from, to, triangle);
    EXPECT_NEAR(distance_m(from + found.along * (to - from), triangle), found.distance_m, 1e-9);
    double least = 1e9;
    for (int n = 0; n <= 200; ++n)
      least = std::min(least, distance_m(from + n / 200.0 * (to - from), triangle));
    EXPECT_GE(least, found.distance_m - 1e-9);
    EXPECT_LE(least, found.distance_m + (to - from).norm() / 400 + 1e-9);
  }
}

/// What Embree leaves out is farther away: the tree says what all triangles together say.
TEST(Distances, AreThoseOfAllTriangles) {
  boost::random::mt19937_64 random(8);
  boost::random::uniform_real_distribution<double> within(-20, 20), small(-1, 1);
  const Vec3 far(4000, -7000, 30);
  Structure mesh;
  for (std::uint32_t t = 0; t < 300; ++t) {
    const double x = within(random), y = within(random);
    const Vec3 at = far + Vec3(x, y, within(random));
    for (int corner = 0; corner < 3; ++corner) {
      const double dx = small(random), dy = small(random);
      mesh.points.push_back(at + Vec3(dx, dy, small(random)));
    }
    mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  const Distances distances(mesh);
  for (int round = 0; round < 300; ++round) {
    const double x = within(random), y = within(random), dx = within(random);
    const Vec3 from = far + Vec3(x, y, within(random)), to = from + Vec3(dx, 3, within(random));
    double point_m = 1000, leg_m = 1000;
    for (const auto& c : mesh.triangles) {
      const Triangle triangle{mesh.points[c[0]], mesh.points[c[1]], mesh.points[c[2]]};
      point_m = std::min(point_m, distance_m(from, triangle));
      leg_m = std::min(leg_m, approach(from, to, triangle).distance_m);
    }
    EXPECT_NEAR(distances.from(from, 1000), point_m, 1e-9);
    EXPECT_NEAR(distances.from(from, to, 1000).distance_m, leg_m, 1e-9);
    EXPECT_EQ(distances.from(from, 0.5 * point_m), 0.5 * point_m);
  }
}

}  // namespace
}  // namespace arcbid::certificate
