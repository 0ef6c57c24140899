// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <cmath>

#include "core/base/error.hpp"
#include "core/structure/bridge_arcs.hpp"
#include "core/structure/parametric.hpp"
#include "tests/structure/arc_laws.hpp"

namespace arcbid {
namespace {

using testing::HasSubstr;

std::string refusal(const Structure& structure) {
  try {
    bridge_arcs(structure, {});
  } catch (const InputError& e) {
    return e.what();
  }
  return "accepted";
}

Structure cloud_of(std::vector<Vec3> points) {
  return {std::move(points), {}};
}

TEST(Hostile, RefusedWithTheReason) {
  const double nan = std::nan("");
  EXPECT_THAT(refusal({}), HasSubstr("no points"));
  EXPECT_THAT(refusal(cloud_of({{1, 2, 3}})), HasSubstr("on one spot"));
  EXPECT_THAT(refusal(cloud_of({{1, 2, 3}, {1, 2, 3}})), HasSubstr("on one spot"));
  EXPECT_THAT(refusal(cloud_of({{0, 0, 0}, {1, nan, 0}})), HasSubstr("point 1 is (1, nan, 0)"));
  EXPECT_THAT(refusal(cloud_of({{0, 0, 0}, {1e300, 0, 0}})), HasSubstr("check the file's unit"));
  EXPECT_THAT(refusal({{{0, 0, 0}, {1, 0, 0}}, {{0, 1, 7}}}),
              HasSubstr("triangle 0 refers to vertex 7; there are 2"));
  EXPECT_THAT(refusal(cloud_of({{0, 0, 0}, {0, 0, 90000}})), HasSubstr("slices"));
  EXPECT_THAT(refusal(box_mesh({0, 0, 0}, {30000, 12000, 9000})),
              HasSubstr("check the file's unit"));
}

std::vector<Vec3> scattered(int side) {
  std::vector<Vec3> points;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) points.emplace_back(50.0 * i, 50.0 * j, 10);
  return points;
}

TEST(Hostile, ScatteredPointsAreFlownOrRefusedInTime) {
  EXPECT_EQ(bridge_arcs(cloud_of(scattered(44)), {}).arcs.size(), 1936u);
  EXPECT_THAT(refusal(cloud_of(scattered(50))), HasSubstr("falls into 2500 parts"));
}

TEST(Hostile, PointsOnALineOrASheetAreFlown) {
  std::vector<Vec3> beam, mast, wall, sheet, slope;
  for (double i = 0; i <= 40; ++i) {
    beam.emplace_back(i, i / 2, 20);
    mast.emplace_back(5, 5, i);
    for (double j = 0; j <= 40; ++j) {
      wall.emplace_back(i, 2 * i, j);
      sheet.emplace_back(i, j, 12);
      slope.emplace_back(i, j, i);
    }
  }
  for (const auto& points : {beam, mast, wall, sheet, slope})
    expect_arc_laws(bridge_arcs(cloud_of(points), {}), cloud_of(points), {});
}

TEST(Hostile, TinyAndTwoPoints) {
  for (const Structure& s :
       {box_mesh({0, 0, 0}, {0.01, 0.02, 0.005}), cloud_of({{0, 0, 0}, {1e-9, 0, 0}}),
        cloud_of({{0, 0, 0}, {0, 0, 1e-300}})})
    expect_arc_laws(bridge_arcs(s, {}), s, {});
}

TEST(Hostile, FlippedRepeatedAndDegenerateTriangles) {
  Structure mesh = generate({});
  const std::size_t count = mesh.triangles.size();
  for (std::size_t t = 0; t < count; t += 2) {
    auto [a, b, c] = mesh.triangles[t];
    mesh.triangles.push_back({c, b, a});
    mesh.triangles.push_back({a, a, b});
    mesh.triangles.push_back({a, a, a});
  }
  mesh.points.emplace_back(1e6, 0, 0);  // no triangle uses it
  const ArcPlan plan = bridge_arcs(mesh, {});
  expect_arc_laws(plan, mesh, {});
  EXPECT_EQ(plan.high_m.x(), 30);
  EXPECT_EQ(plan.arcs.size(), bridge_arcs(generate({}), {}).arcs.size());
}

TEST(Hostile, AMeshWithoutAreaIsAWireToKeepClearOf) {
  Structure wire{{{0, 0, 20}, {50, 0, 20}, {25, 0, 20}}, {{0, 1, 2}}};
  const ArcPlan plan = bridge_arcs(wire, {});
  EXPECT_EQ(plan.surface_m2, 0);
  for (const Vec3& p : along_arcs(plan.arcs, 0.2))
    EXPECT_GE((p - Vec3(std::clamp(p.x(), 0.0, 50.0), 0, 20)).norm(), 2);
}

TEST(Hostile, FarFromTheOrigin) {
  Structure mesh = generate({});
  for (Vec3& p : mesh.points) p += Vec3(637000, 850000, 500);
  expect_arc_laws(bridge_arcs(mesh, {}), mesh, {});
  EXPECT_EQ(bridge_arcs(mesh, {}).arcs.size(), bridge_arcs(generate({}), {}).arcs.size());
}

}  // namespace
}  // namespace arcbid
