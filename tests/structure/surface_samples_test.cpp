// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/base/error.hpp"
#include "core/structure/structure.hpp"
#include "tests/structure/arc_laws.hpp"

namespace arcbid {
namespace {

TEST(SurfaceSamples, MeshIsSampledByAreaOnItsSurface) {
  const Structure box = box_mesh({0, 0, 0}, {10, 4, 2});
  const std::vector<Vec3> samples = surface_samples(box, 0.1, 7);
  ASSERT_EQ(samples.size(), 13600u);  // 136 m2 at 100 a m2
  std::size_t top = 0;
  for (const Vec3& p : samples) {
    const Vec3 off = p.cwiseMin(Vec3(10, 4, 2) - p);  // from the nearest face along each axis
    ASSERT_NEAR(off.minCoeff(), 0, 1e-9);
    top += p.z() > 2 - 1e-9;
  }
  EXPECT_NEAR(static_cast<double>(top), 4000, 4);  // stratified: exact but for strata that straddle
}

TEST(SurfaceSamples, AreUniformWithinATriangle) {
  Structure mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  Vec3 sum = Vec3::Zero();
  const std::vector<Vec3> samples = surface_samples(mesh, 0.005, 1);
  for (const Vec3& p : samples) sum += p;
  EXPECT_LT((sum / static_cast<double>(samples.size()) - Vec3(1, 1, 0) / 3).norm(), 0.01);
}

TEST(SurfaceSamples, TheSeedDecidesTheSamples) {
  const Structure box = box_mesh({0, 0, 0}, {10, 4, 2});
  EXPECT_EQ(surface_samples(box, 0.5, 1), surface_samples(box, 0.5, 1));
  EXPECT_NE(surface_samples(box, 0.5, 1), surface_samples(box, 0.5, 2));
}

TEST(SurfaceSamples, CloudKeepsThePointNearestToTheVoxelsCentre) {
  Structure cloud;
  cloud.points = {{0, 0, 0}, {0.4, 0.5, 0.5}, {0.5, 0.6, 0.5}, {1.5, 0, 0}, {0, 0, 3}};
  const std::vector<Vec3> expected{{0.4, 0.5, 0.5}, {1.5, 0, 0}, {0, 0, 3}};  // ties: the first
  EXPECT_EQ(surface_samples(cloud, 1, 1), expected);
}

TEST(SurfaceSamples, RefuseWhatCannotBeSampled) {
  Structure cloud;
  EXPECT_THROW(surface_samples(cloud, 1, 1), InputError);
  cloud.points = {{0, 0, 0}, {1, 0, std::nan("")}};
  EXPECT_THROW(surface_samples(cloud, 1, 1), InputError);
  cloud.points = {{0, 0, 0}, {1, 0, 0}};
  EXPECT_THROW(surface_samples(cloud, 0, 1), InputError);
  EXPECT_THROW(surface_samples(box_mesh({0, 0, 0}, {1e5, 1e5, 1}), 0.01, 1), InputError);
}

TEST(SurfaceSamples, MeshWithoutAreaHasNone) {
  Structure mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  mesh.triangles = {{0, 1, 2}};
  EXPECT_TRUE(surface_samples(mesh, 0.1, 1).empty());
}

}  // namespace
}  // namespace arcbid
