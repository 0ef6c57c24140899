// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "tests/readers/samples.hpp"

namespace arcbid {
namespace {

using testing::HasSubstr;

double area_m2(const Structure& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sum += 0.5 * (mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]).norm();
  }
  return sum;
}

/// One polygon through `corners`, tilted so that no axis plane is special.
std::string polygon_obj(const std::vector<Eigen::Vector2d>& corners) {
  std::string text, face = "f";
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 p = corners[i].x() * Vec3(0.6, 0, 0.8) + corners[i].y() * Vec3(0, 1, 0);
    text += fmt::format("v {} {} {}\n", p.x(), p.y(), p.z());
    face += fmt::format(" {}", i + 1);
  }
  return text + face + "\n";
}

TEST(Polygons, ConvexKeepsItsArea) {
  const auto input = samples::read("p.obj", polygon_obj({{0, 0}, {4, 0}, {6, 3}, {4, 6}, {0, 6}}));
  EXPECT_EQ(input.structure.triangles.size(), 3u);
  EXPECT_NEAR(area_m2(input.structure), 30, 1e-9);
}

TEST(Polygons, ConcaveIsNotCoveredOutside) {
  // An L, both ways around; a fan from its first corner would have area 24, not 20.
  std::vector<Eigen::Vector2d> corners{{6, 0}, {6, 2}, {2, 2}, {2, 6}, {0, 6}, {0, 0}};
  for (int turn = 0; turn < 2; ++turn) {
    const auto input = samples::read("p.obj", polygon_obj(corners));
    EXPECT_EQ(input.structure.triangles.size(), 4u);
    EXPECT_NEAR(area_m2(input.structure), 20, 1e-9);
    std::reverse(corners.begin(), corners.end());
  }
}

TEST(Polygons, ConcaveKeepsItsSense) {
  const auto input = samples::read("p.obj", polygon_obj({{0, 0}, {6, 0}, {2, 2}, {0, 6}}));
  const Vec3 expected = Vec3(0.6, 0, 0.8).cross(Vec3(0, 1, 0));
  for (const auto& [a, b, c] : input.structure.triangles) {
    const auto& p = input.structure.points;
    EXPECT_GT((p[b] - p[a]).cross(p[c] - p[a]).dot(expected), 0);
  }
}

TEST(Polygons, SelfCrossingIsStillRead) {
  const auto input = samples::read("p.obj", polygon_obj({{0, 0}, {5, 5}, {5, 0}, {0, 4}}));
  EXPECT_EQ(input.structure.triangles.size(), 2u);
}

TEST(Polygons, FewerThanThreeCorners) {
  const auto input = samples::read("p.obj", "v 0 0 0\nv 3 0 0\nv 0 3 0\nf 1 2\nf 1 2 3\nf 2\n");
  EXPECT_EQ(input.structure.triangles.size(), 1u);
  EXPECT_THAT(samples::warnings(input), HasSubstr("dropped 2 faces with fewer than three corners"));
}

TEST(Polygons, IndexOutOfRangeNamesTheLineOrFace) {
  const std::string vertices = "v 0 0 0\nv 3 0 0\nv 0 3 0\n";
  EXPECT_EQ(samples::error("p.obj", vertices + "f 1 2 3\nf 1 2 4\n"),
            "p.obj:5: a corner is vertex 3 (counted from 0), but the file has 3 vertices");
  EXPECT_EQ(samples::error("p.obj", vertices + "f 1 2 -4\n"),
            "p.obj:4: face corner '-4': only 3 vertices stand before this line");
  EXPECT_THAT(samples::error("p.obj", vertices + "f 1 2 0\n"),
              HasSubstr("p.obj:4: face corner '0'"));
  EXPECT_THAT(samples::error("p.obj", vertices + "f 1 2 x\n"),
              HasSubstr("p.obj:4: face corner 'x'"));

  std::string binary = samples::ply("binary_little_endian");
  const std::size_t face_bytes = 1 + 3 * 4 + 2;
  samples::put(binary, binary.size() - 2 * face_bytes + 1, std::int32_t{-7});
  EXPECT_EQ(samples::error("p.ply", binary),
            "p.ply: face 10: a corner is vertex -7 (counted from 0), but the file has 8 vertices");
}

TEST(Polygons, ThousandsOfCornersTakeNoTime) {
  std::vector<Eigen::Vector2d> comb;
  for (int i = 0; i < 2000; ++i) comb.emplace_back(0.1 * i, i % 2 ? 5.0 : 1.0);
  comb.emplace_back(200, 0);
  comb.emplace_back(0, 0);
  const auto input = samples::read("p.obj", polygon_obj(comb));
  EXPECT_NEAR(area_m2(input.structure), 1999 * 0.1 * 3 + 0.25, 1e-6);
  std::vector<Eigen::Vector2d> circle;
  for (int i = 0; i < 10'001; ++i)
    circle.emplace_back(9 * std::cos(i * 6e-4), 9 * std::sin(i * 6e-4));
  EXPECT_THAT(samples::error("p.obj", polygon_obj(circle)), HasSubstr("10,001 corners"));
}

}  // namespace
}  // namespace arcbid
