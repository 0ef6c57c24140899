// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/coverage/coverage_arcs.hpp"
#include "tests/coverage_plan/brute_force.hpp"
#include "tests/structure/arc_laws.hpp"

namespace arcbid {
namespace {

struct Shape {
  const char* name;
  Structure mesh;
  bool camera;
  double goal;  ///< share of what can be seen
};
void PrintTo(const Shape& s, std::ostream* out) {
  *out << s.name << (s.camera ? ", camera" : ", lidar");
}

Structure wall_with_slit() {
  return joined(box_mesh({-8, -0.2, 0}, {-0.5, 0.2, 9}), box_mesh({0.5, -0.2, 0}, {8, 0.2, 9}));
}
Structure plates() {
  return joined(box_mesh({-6, -6, 6}, {6, 6, 6.3}), box_mesh({-6, -6, 9.3}, {6, 6, 9.6}));
}
std::vector<Shape> shapes() {
  std::vector<Shape> all;
  for (const bool camera : {false, true}) {
    const double goal = camera ? 0.995 : 0.999;
    all.push_back({"slab", box_mesh({-9, -4, 8}, {9, 4, 9}, 0.3), camera, goal});
    all.push_back({"wall with slit", wall_with_slit(), camera, goal});
    all.push_back({"closed box", box_mesh({-2, -3, 5}, {2, 3, 9}), camera, goal});
    // Nobody can fly between them: the last that is seen there is seen from hardly anywhere, and
    // the planner does not find all of it.
    all.push_back({"two plates", plates(), camera, camera ? goal : 0.998});
  }
  return all;
}

class Shapes : public testing::TestWithParam<Shape> {};

TEST_P(Shapes, AreCoveredAsFarAsTheyCanBeSeen) {
  const Structure& mesh = GetParam().mesh;
  CoverageSettings settings;
  settings.ground_m = 0;
  if (GetParam().camera) settings.sensor = camera_preset();
  const ArcPlan plan = coverage_arcs(mesh, settings);
  const BruteForce brute(mesh, settings);
  EXPECT_GE(brute.least_clearance_m(plan.arcs), settings.safety_m);
  const BruteForce::Count count = brute.count(plan.arcs, 77);
  EXPECT_GE(count.share(), GetParam().goal);
  // The planner sees as much as there is to be seen.
  const double share = static_cast<double>(plan.planned.visible) / plan.planned.samples;
  EXPECT_NEAR(share, static_cast<double>(count.visible) / count.samples, 0.02);
  for (const Arc& arc : plan.arcs) {
    ASSERT_GE(arc.waypoints.size(), 2u);
    for (std::size_t k = 1; k < arc.waypoints.size(); ++k)
      EXPECT_NE(arc.waypoints[k - 1].position_m, arc.waypoints[k].position_m);
    for (const Waypoint& w : arc.waypoints) {
      EXPECT_GE(w.position_m.z(), settings.ground_clearance_m - 1e-9);
      EXPECT_NEAR(w.look.norm(), 1, 1e-9);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, Shapes, testing::ValuesIn(shapes()));

TEST(ShapesSeen, InsideOfAClosedBoxIsInvisible) {
  const ArcPlan plan = coverage_arcs(box_mesh({-5, -5, 6}, {5, 5, 16}), {});
  EXPECT_LE(plan.planned.visible, plan.planned.samples / 2);
}

TEST(ShapesSeen, FlippedTrianglesChangeNothing) {
  Structure mesh = box_mesh({-5, -3, 6}, {5, 3, 8});
  CoverageSettings settings;
  settings.ground_m = 0;
  const ArcPlan plan = coverage_arcs(mesh, settings);
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 2)
    std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
  const ArcPlan flipped = coverage_arcs(mesh, settings);
  EXPECT_NEAR(static_cast<double>(flipped.planned.visible), plan.planned.visible,
              0.02 * plan.planned.visible);
}

}  // namespace
}  // namespace arcbid
