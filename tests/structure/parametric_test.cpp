// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structure/parametric.hpp"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <cmath>

#include "core/base/error.hpp"

namespace arcbid {
namespace {

double area_m2(const Structure& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    sum += 0.5 * (mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]).norm();
  return sum;
}

/// By the divergence theorem: right only if every face looks outward.
double volume_m3(const Structure& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    sum += mesh.points[a].dot(mesh.points[b].cross(mesh.points[c])) / 6;
  return sum;
}

double box_area_m2(double x, double y, double z) {
  return 2 * (x * y + y * z + z * x);
}

TEST(Generate, GirderBridgeHasTheAreaAndVolumeOfItsBoxes) {
  const ParametricBridge b;  // 60 x 12, deck 11..12, girders 9.5..11, each 0.75 wide, piers to 9.5
  const Structure mesh = generate(b);
  EXPECT_NEAR(
      area_m2(mesh),
      box_area_m2(60, 12, 1) + 4 * box_area_m2(60, 0.75, 1.5) + 3 * box_area_m2(2, 7.2, 9.5), 1e-9);
  EXPECT_NEAR(volume_m3(mesh), 60 * 12 * 1 + 4 * 60 * 0.75 * 1.5 + 3 * 2 * 7.2 * 9.5, 1e-6);
}

TEST(Generate, ArchRibsHaveTheAreaOfTheirSegments) {
  ParametricBridge b;
  b.kind = BridgeKind::arch;
  b.piers = b.girders = 0;
  double run_m = 0;  // of the rib's top, a parabola in 32 segments
  for (int i = 0; i < 32; ++i) {
    const auto z = [](int k) { return 28 * (1 - std::pow(k / 16.0 - 1, 2)); };
    run_m += std::hypot(60 / 32.0, z(i + 1) - z(i));
  }
  const double rib =
      2 * 60 * 2 /* sides */ + 2 * run_m * 2 /* top, bottom */ + 2 * 2 * 2 /* ends */;
  EXPECT_NEAR(area_m2(generate(b)), box_area_m2(60, 12, 1) + 2 * rib, 1e-9);
  EXPECT_NEAR(volume_m3(generate(b)), 60 * 12 + 2 * 60 * 2 * 2, 1e-6);
}

TEST(Generate, TowersStandBesideTheDeckAndReachTheirHeight) {
  ParametricBridge b;
  b.kind = BridgeKind::towers;
  b.piers = 2;
  b.girders = 0;
  const Structure mesh = generate(b);
  const double tower = 2 * box_area_m2(2, 2, 30) + 2 * box_area_m2(2, 12, 2);
  EXPECT_NEAR(area_m2(mesh), box_area_m2(60, 12, 1) + 2 * tower, 1e-9);
  double high = 0;
  for (const Vec3& p : mesh.points) {
    high = std::max(high, p.z());
    EXPECT_GE(p.z(), 0);
    EXPECT_LE(std::abs(p.y()), 8);
  }
  EXPECT_EQ(high, 30);
}

TEST(Generate, NamesTheFieldThatIsWrong) {
  const auto message = [](auto change) -> std::string {
    ParametricBridge b;
    change(b);
    try {
      generate(b);
    } catch (const InputError& e) {
      return e.what();
    }
    return "accepted";
  };
  EXPECT_EQ(message([](auto& b) { b.length_m = -1; }),
            "parametric.length_m: -1 is outside [1, 20000]");
  EXPECT_THAT(message([](auto& b) { b.width_m = std::nan(""); }),
              testing::HasSubstr("width_m: nan"));
  EXPECT_THAT(message([](auto& b) { b.girder_depth_m = 11.5; }), testing::HasSubstr("[0.05, 11]"));
  EXPECT_THAT(message([](auto& b) { b.pier_width_m = 30; }), testing::HasSubstr("pier_width_m"));
  EXPECT_THAT(message([](auto& b) { b.piers = 100000; }), testing::HasSubstr("piers: 100000"));
  EXPECT_THAT(message([](auto& b) {
                b.kind = BridgeKind::towers;
                b.tower_height_m = 5;
              }),
              testing::HasSubstr("tower_height_m: 5 is outside [12, 2000]"));
}

}  // namespace
}  // namespace arcbid
