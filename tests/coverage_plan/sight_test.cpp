// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/random/uniform_real_distribution.hpp>
#include <random>

#include "core/coverage/coverage_arcs.hpp"
#include "core/coverage/outlook.hpp"
#include "core/coverage/trim.hpp"
#include "tests/structure/arc_laws.hpp"

namespace arcbid {
namespace {

TEST(SeenAlong, IsWhatAllStationsSeeTogether) {
  const Structure mesh = joined(box_mesh({-6, -3, 4}, {6, 3, 5}), box_mesh({-1, -1, 0}, {1, 1, 4}));
  for (const Sensor& sensor : {lidar_preset(), camera_preset()}) {
    CoverageSettings settings;
    settings.sensor = sensor;
    const ArcPlan plan = bridge_arcs(mesh, settings);
    const Surface surface = surface_of(mesh, {}, 1);
    std::vector<Arc> arcs = plan.arcs;
    for (Arc& arc : arcs)
      for (Waypoint& w : arc.waypoints) w.position_m -= surface.origin_m;
    const Scene scene(surface);
    const Samples samples = sided_samples(surface, 0.4, 3);
    const Seer seer(scene, surface, samples, sensor);
    std::vector<Wanted> wanted(samples.size(), Wanted::narrow);
    for (std::size_t s = 0; s < wanted.size(); s += 3) wanted[s] = Wanted::nominal;
    for (std::size_t s = 1; s < wanted.size(); s += 3) wanted[s] = Wanted::no;
    std::vector<bool> expected(samples.size());
    for (const SeenArc& arc : look_along(seer, arcs, wanted, 2))
      for (const Seen& seen : arc.seen)
        for (const std::uint32_t s : seen) expected[s] = true;
    const std::vector<bool> seen = seen_along(seer, arcs, wanted, 2);
    EXPECT_EQ(seen, expected);
    EXPECT_NE(std::count(seen.begin(), seen.end(), true), 0);
  }
}

TEST(Cloud, HidesWhatIsBehindItHoweverItsPointsFell) {
  std::mt19937 random(11);
  boost::random::uniform_real_distribution<double> uniform(-5, 5);
  Structure plate;
  for (int k = 0; k < 3500; ++k) plate.points.emplace_back(uniform(random), uniform(random), 0);
  const Surface surface = surface_of(plate, {}, 2);
  const Scene scene(surface);
  const auto away = static_cast<float>(surface.origin_m.z());
  int hidden = 0;
  constexpr int kLines = 4000;
  for (int k = 0; k < kLines; ++k) {
    const Vec3f p = 0.9F * Vec3(uniform(random), uniform(random), 0).cast<float>();
    const Vec3f from = p + Vec3f(0, 0, 1 - away), to = p - Vec3f(0, 0, 1 + away);
    hidden += static_cast<int>(scene.hidden(&from, &to, 1));
  }
  EXPECT_GE(hidden, 0.995 * kLines);
  // Beyond its rim it hides nothing.
  for (double x = -5; x <= 5; x += 0.1) {
    const Vec3f from(static_cast<float>(x), 5.6F, 1), to(static_cast<float>(x), 5.6F, -1);
    EXPECT_EQ(scene.hidden(&from, &to, 1), 0u);
  }
}

TEST(Outlook, GivesUpOnlyWhereSeveralWereTriedOnThatSideAndNoneWasVisible) {
  Outlook outlook;
  const Vec3f p(0.1F, -0.2F, 7.3F), up = Vec3f::UnitZ();
  EXPECT_FALSE(outlook.hopeless(p, up));
  outlook.learn(p, up, false);
  EXPECT_FALSE(outlook.hopeless(p, up));
  outlook.learn(p, up, false);
  EXPECT_TRUE(outlook.hopeless(p, up));
  EXPECT_FALSE(outlook.hopeless(p, -up));
  EXPECT_FALSE(outlook.hopeless(p, Vec3f::UnitX()));
  EXPECT_FALSE(outlook.hopeless(p + Vec3f(0.7F, 0, 0), up));
  EXPECT_FALSE(outlook.hopeless(p - Vec3f(0, 0, 0.7F), up));
  outlook.learn(p, up, true);
  EXPECT_FALSE(outlook.hopeless(p, up));
}

}  // namespace
}  // namespace arcbid
