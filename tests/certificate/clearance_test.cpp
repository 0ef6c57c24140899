// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <limits>
#include <numeric>

#include "core/base/error.hpp"
#include "sim/certificate/files.hpp"
#include "tests/certificate/shapes.hpp"

namespace arcbid::certificate {
namespace {

using testing::add_box;
using testing::flown;
using testing::level_plate;
using testing::settings;

Structure mast() {
  Structure mesh;
  add_box(mesh, {-0.05, -0.05, 10}, {0.05, 0.05, 20});
  return mesh;
}

TEST(Clearance, BetweenWaypointsThatAreFarAway) {
  const Certificate c = certify(mast(), flown({{-40, 0.35, 15}, {60, 0.35, 15}}), settings());
  EXPECT_NEAR(c.min_clearance_m(), 0.3, 1e-9);
  EXPECT_NEAR(c.clearance[0].flight.at_m.x(), 0, 0.06);
  EXPECT_FALSE(c.keeps_clear());
}

TEST(Clearance, JustEnoughIsEnough) {
  EXPECT_TRUE(certify(mast(), flown({{-40, 2.05, 15}, {60, 2.05, 15}}), settings()).keeps_clear());
  EXPECT_FALSE(certify(mast(), flown({{-40, 2.04, 15}, {60, 2.04, 15}}), settings()).keeps_clear());
}

TEST(Clearance, OfACloudItIsThatOfItsPoints) {
  Structure cloud;
  cloud.points = {{0, 0, 10}, {1, 0, 10}, {0, 1, 10}};
  const Certificate c = certify(cloud, flown({{-9, 0, 12.5}, {9, 0, 12.5}}), settings());
  EXPECT_NEAR(c.min_clearance_m(), 2.5, 1e-9);
}

TEST(Clearance, TakingOffBesideAWallIsSaidApart) {
  Structure wall;
  testing::add_plate(wall, {0, -10, 0}, {0, 20, 0}, {0, 0, 10});
  const Vec3 look(1, 0, 0), home(-1, 0, 0), above(-1, 0, 3), out(-4, 0, 6);
  Flown f;
  f.flights = {{7,
                {{std::nullopt, {{home, look}, {above, look}, {out, look}}},
                 {0u, {{out, look}, {out + Vec3(0, 5, 0), look}}},
                 {std::nullopt, {{out + Vec3(0, 5, 0), look}, {{-4, 5, 0}, look}}}}}};
  const Certificate c = certify(wall, f, settings());
  EXPECT_NEAR(c.home_clearance_m(), 1, 1e-6);
  EXPECT_NEAR(c.min_clearance_m(), 1, 1e-5);  // where the column ends, at the floor
  EXPECT_EQ(c.clearance[0].agent, 7u);
  EXPECT_EQ(c.clearance[0].flight.leg, 0u);
  EXPECT_EQ(c.below_floor_m(), 0);
  EXPECT_FALSE(c.keeps_clear());
  f.flights[0].legs[1].waypoints[1].position_m.z() = 0;
  EXPECT_GT(certify(wall, f, settings()).below_floor_m(), 2);
}

/// Only straight over a home is taking off: a detour under the floor is flight.
TEST(Clearance, ADetourUnderTheFloorIsFlight) {
  Structure wall;
  testing::add_plate(wall, {0, -10, 0}, {0, 20, 0}, {0, 0, 10});
  const Vec3 look(1, 0, 0), home(-5, 0, 0), beyond(5, 0, 2), out(-5, 0, 6);
  Flown f;
  f.flights = {{1,
                {{std::nullopt, {{home, look}, {beyond, look}, {home, look}, {out, look}}},
                 {0u, {{out, look}, {out + Vec3(0, 5, 0), look}}},
                 {std::nullopt, {{out + Vec3(0, 5, 0), look}, {{-5, 5, 0}, look}}}}}};
  const Certificate through = certify(wall, f, settings());
  EXPECT_NEAR(through.min_clearance_m(), 0, 1e-6);
  EXPECT_FALSE(through.keeps_clear());
  EXPECT_GT(through.below_floor_m(), 20);
  f.flights[0].legs[0].waypoints = {{home, look}, {out, look}};
  EXPECT_TRUE(certify(wall, f, settings()).keeps_clear());
}

TEST(Clearance, NothingFlownIsNoClearance) {
  const Certificate c = certify(mast(), {}, settings());
  EXPECT_TRUE(to_json(c)["min_clearance_m"].is_null());
  EXPECT_TRUE(c.keeps_clear());
  EXPECT_EQ(c.covered_samples, 0u);
}

TEST(Certificate, IsTheSameWithOneThreadAndWithTwo) {
  Structure mesh = level_plate(8, 10);
  add_box(mesh, {-3, -3, 13}, {3, 1, 16});
  const Flown f = flown({{-8, 0, 20}, {8, 0, 20}, {8, 6, 15}});
  Settings one = settings(), two = settings();
  one.threads = 1;
  two.threads = 2;
  const Certificate a = certify(mesh, f, one), b = certify(mesh, f, two);
  EXPECT_EQ(to_json(a), to_json(b));
  EXPECT_EQ(samples_file(a), samples_file(b));
  EXPECT_EQ(samples_file(a).size(), 16 + 20 * a.samples.size());
}

TEST(Certificate, OtherSeedsGiveOtherSamples) {
  Settings other = settings();
  other.mission_seed = 2;
  const Flown f = flown({{-5, 0, 14}, {5, 0, 14}});
  const Certificate a = certify(level_plate(5, 10), f, settings()),
                    b = certify(level_plate(5, 10), f, other);
  EXPECT_NE(a.samples[0].position_m, b.samples[0].position_m);
  EXPECT_NE(a.seed, settings().mission_seed);
}

TEST(Certificate, AddsUp) {
  boost::random::mt19937_64 random(3);
  boost::random::uniform_real_distribution<double> within(-6, 6);
  boost::random::uniform_int_distribution<std::uint32_t> corner(0, 19);
  for (int round = 0; round < 12; ++round) {
    Structure mesh;
    for (int p = 0; p < 20; ++p) {
      const double x = within(random), y = within(random);
      mesh.points.emplace_back(x, y, 8 + within(random));
    }
    // Corners may repeat: triangles without area, folded onto each other, non-manifold.
    for (int t = 0; t < 12; ++t) {
      const std::uint32_t a = corner(random), b = corner(random);
      mesh.triangles.push_back({a, b, corner(random)});
    }
    const Certificate c = certify(mesh, flown({{-9, -9, 20}, {9, 9, 20}}), settings());
    EXPECT_EQ(std::accumulate(c.fates.begin(), c.fates.end(), std::uint64_t{0}), c.surface_samples);
    EXPECT_EQ(c.fates[0], c.covered_samples);
    EXPECT_LE(c.covered_visible_samples, c.visible_samples);
    EXPECT_LE(c.visible_samples, c.surface_samples);
    EXPECT_EQ(std::accumulate(c.redundancy.histogram.begin(), c.redundancy.histogram.end(),
                              std::uint64_t{0}),
              c.covered_samples);
    EXPECT_GE(c.visible_samples, c.fates[static_cast<std::size_t>(Fate::missed)]);
  }
}

TEST(Certificate, AwkwardStructures) {
  Structure point, line, wire;
  point.points = {{5, 5, 5}};
  for (int n = 0; n < 50; ++n) line.points.emplace_back(0.2 * n, 0, 10);
  wire.points = {{0, 0, 10}, {5, 0, 10}, {10, 0, 10}};
  wire.triangles = {{0, 1, 2}};
  for (const Structure& s : {point, line, wire}) {
    const Certificate c = certify(s, flown({{0, 0, 14}, {9, 0, 14}}), settings());
    EXPECT_GT(c.min_clearance_m(), 3.9);
  }
  EXPECT_THROW(certify({}, {}, settings()), InputError);
  point.points[0].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(certify(point, {}, settings()), InputError);
  wire.triangles = {{0, 1, 3}};
  EXPECT_THROW(certify(wire, {}, settings()), InputError);
}

TEST(Certificate, FarFromTheOriginAndLarge) {
  Structure plate = level_plate(5, 10);
  const Vec3 far(800000, -900000, 0);
  for (Vec3& p : plate.points) p += far;
  const Certificate c =
      certify(plate, flown({far + Vec3(-5, 0, 14), far + Vec3(5, 0, 14)}), settings());
  EXPECT_DOUBLE_EQ(c.coverage_of_visible(), 0.5);
  EXPECT_NEAR(c.min_clearance_m(), 4, 1e-6);
}

}  // namespace
}  // namespace arcbid::certificate
