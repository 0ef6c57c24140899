// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <algorithm>

#include "core/base/error.hpp"
#include "core/coverage/coverage_arcs.hpp"
#include "tests/structure/arc_laws.hpp"

namespace arcbid {
namespace {

using testing::Contains;
using testing::HasSubstr;

std::string refusal(const Structure& structure, const CoverageSettings& settings = {}) {
  try {
    coverage_arcs(structure, settings);
  } catch (const InputError& e) {
    return e.what();
  }
  return "accepted";
}

TEST(SmallStructures, WithoutExtentAreRefused) {
  EXPECT_THAT(refusal({}), HasSubstr("no points"));
  EXPECT_THAT(refusal({{{1, 2, 3}}, {}}), HasSubstr("on one spot"));
  EXPECT_THAT(refusal({{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}, {{0, 1, 2}}}), HasSubstr("on one spot"));
}

/// Two points, a line of points, and a thing of 0.1 m: flown around, never nearer than allowed.
TEST(SmallStructures, AreFlownAround) {
  std::vector<Vec3> line;
  for (double t = 0; t <= 12; t += 0.3) line.emplace_back(t, t / 3, 6 + t / 2);
  for (const Structure& s : {Structure{{{0, 0, 8}, {5, 1, 9}}, {}}, Structure{line, {}},
                             box_mesh({0, 0, 8}, {0.1, 0.05, 8.1})}) {
    CoverageSettings settings;
    settings.ground_m = 0;
    const ArcPlan plan = coverage_arcs(s, settings);
    ASSERT_FALSE(plan.arcs.empty());
    const NearPoints near(s.points, 4);
    for (const Vec3& p : along_arcs(plan.arcs, 0.1))
      ASSERT_GE(near.distance_m(p), settings.safety_m - 1e-9);
  }
}

/// Without area there is nothing to be covered, and without arcs nothing to be flown.
TEST(SmallStructures, AWireIsFlownAroundAndSaidSo) {
  const Structure wire{{{0, 0, 20}, {50, 0, 20}, {25, 0, 20}}, {{0, 1, 2}}};
  const ArcPlan plan = coverage_arcs(wire, {});
  EXPECT_EQ(digest(plan.arcs), digest(bridge_arcs(wire, {}).arcs));
  EXPECT_THAT(plan.warnings, Contains(HasSubstr("too small for its coverage")));
}

TEST(SmallStructures, OfATenthOfAMetreAreSeenFromAllSides) {
  CoverageSettings settings;
  settings.ground_m = 0;
  const ArcPlan plan = coverage_arcs(box_mesh({0, 0, 8}, {0.1, 0.05, 8.1}), settings);
  EXPECT_GT(plan.planned.visible, 100u);
  EXPECT_EQ(plan.planned.covered, plan.planned.visible);
}

/// In the frame that arcs are planned in, z of this floor is rounded down.
TEST(Floor, IsKeptToTheLastBit) {
  CoverageSettings settings;
  settings.ground_clearance_m = 1.3;
  const double floor_m = 0.3 + settings.ground_clearance_m;
  ASSERT_LT((floor_m - 6.5) + 6.5, floor_m);
  const ArcPlan plan = coverage_arcs(box_mesh({0, 0, 0.3}, {9, 4, 12.7}), settings);
  double lowest_m = 1e9;
  for (const Arc& arc : plan.arcs)
    for (const Waypoint& w : arc.waypoints) lowest_m = std::min(lowest_m, w.position_m.z());
  EXPECT_EQ(lowest_m, floor_m);
}

TEST(Sight, ThatReachesNothingIsRefused) {
  CoverageSettings settings;
  settings.sensor.range_m = 1.5;
  EXPECT_THAT(refusal(box_mesh({0, 0, 0}, {9, 4, 12}), settings),
              HasSubstr("no arc sees any of it"));
}

TEST(StrayVertices, ChangeNothing) {
  Structure mesh = box_mesh({0, 0, 0}, {9, 4, 12});
  const std::uint64_t without = digest(coverage_arcs(mesh, {}).arcs);
  mesh.points.emplace_back(-9e5, 9e5, 9e5);
  EXPECT_EQ(digest(coverage_arcs(mesh, {}).arcs), without);
}

}  // namespace
}  // namespace arcbid
