// SPDX-License-Identifier: GPL-3.0-or-later
// Files that other people's programs wrote. Counts are those of the data's own description, minus
// duplicates and triangles without area.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <chrono>

#include "core/base/error.hpp"
#include "tests/readers/samples.hpp"

namespace arcbid {
namespace {

using testing::HasSubstr;

const std::filesystem::path kFolder = std::filesystem::path(ARCBID_SHARED_DATA) / "geometry";

struct Expected {
  std::string file;
  std::size_t points, triangles;
  Vec3 size_m;
  double tolerance_m = 0.06;  ///< the description rounds
  ReadOptions options = {};
};

void PrintTo(const Expected& expected, std::ostream* out) {
  *out << expected.file;
}

class ThirdParty : public testing::TestWithParam<Expected> {};

TEST_P(ThirdParty, CountsAndExtents) {
  const Expected& expected = GetParam();
  if (!std::filesystem::exists(kFolder / expected.file)) GTEST_SKIP() << "no third-party data here";
  const auto [structure, warnings] = read_structure(kFolder / expected.file, expected.options);
  EXPECT_EQ(structure.points.size(), expected.points);
  EXPECT_EQ(structure.triangles.size(), expected.triangles);
  Eigen::AlignedBox3d box;
  for (const Vec3& point : structure.points) box.extend(point);
  EXPECT_LT((box.sizes() - expected.size_m).cwiseAbs().maxCoeff(), expected.tolerance_m)
      << box.sizes().transpose();
}

INSTANTIATE_TEST_SUITE_P(
    Geometry, ThirdParty,
    testing::Values(
        // 82 vertices, one of which no triangle uses
        Expected{"bridges/truss_span_48m.ply", 81, 214, {51.5, 5.0, 21.0}},
        Expected{"bridges/quinte_skyway.stl", 416, 664 - 83, {915, 20, 94.6}, 0.6},
        Expected{"bridges/duluth_aerial_lift_bridge.obj", 247, 448, {168, 10, 67.6}, 0.6},
        Expected{"bridges/gazebo_truss_bridge.ply", 2392, 3404, {8.5, 15.6, 4.9}},
        // eight of the triangles have no area
        Expected{"bridges/gazebo_cloverleaf_inches.obj",
                 916,
                 1564 - 8,
                 {355.6, 355.9, 6.7},
                 0.06,
                 {.unit = "in"}},
        Expected{"bridges/girder_bridge_cloud.pcd", 285'546 - 55'890, 0, {40, 16, 10}, 0.6},
        Expected{"aircraft/a380.ply", 6807, 12'465 - 1, {72.7, 79.7, 24.2}},
        Expected{"aircraft/atr72.obj", 3797, 7026, {27.2, 27.1, 7.4}},
        Expected{"aircraft/dr400.stl", 5526, 10'312, {7.0, 8.7, 2.2}},
        Expected{"structures/fcplanner_pipe_ascii.pcd", 19'485, 0, {73.3, 66.4, 40.8}},
        Expected{"structures/fcplanner_tianqin_compressed.pcd", 33'798, 0, {31.4, 30.7, 9.5}},
        Expected{"structures/caric_crane_dense.pcd", 34'068, 0, {79.7, 97.2, 75.7}},
        // header boxes: 635619.85..638982.55, 848899.70..853535.43, 406.59..586.38 feet
        Expected{
            "formats/simple.las", 1065, 0, {1024.951, 1412.970, 54.800}, 0.001, {.unit = "ft"}},
        Expected{"formats/1.2-with-color.las", 1065, 0, {3362.70, 4635.73, 179.79}, 0.001},
        Expected{"formats/test1_4.las", 1000, 0, {501.2314, 5.2701, 6.3199}, 0.001},
        Expected{"formats/hextest.las", 8, 0, {2.0, 2.31, 0.0}, 0.001},
        Expected{"formats/autzen-utm.pcd", 1065, 0, {1023, 1411, 180}, 200}));

TEST(ThirdPartyRefusals, OneClearLine) {
  if (!std::filesystem::exists(kFolder)) GTEST_SKIP() << "no third-party data here";
  const std::pair<std::string, std::string> expected[] = {
      {"epsg_4326.las", "degrees of longitude and latitude"},
      {"simple.laz", "laszip -i "},
      {"autzen_trim.laz", "laszip -i "},
      {"A_B.e57", "pdal translate "}};
  for (const auto& [file, text] : expected) {
    try {
      read_structure(kFolder / "formats" / file, {});
      ADD_FAILURE() << file << " was read";
    } catch (const InputError& e) {
      EXPECT_THAT(e.what(), HasSubstr(text));
      EXPECT_THAT(e.what(), HasSubstr(file));
    }
  }
}

TEST(ThirdPartySpeed, LargestCloudInWellUnderASecond) {
  const auto file = kFolder / "bridges/girder_bridge_cloud.pcd";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no third-party data here";
  const auto begin = std::chrono::steady_clock::now();
  const auto input = read_structure(file, {});
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  EXPECT_LT(took.count(), 2.0);  // measured 0.1 s; the slack is for busy machines and sanitizers
}

}  // namespace
}  // namespace arcbid
