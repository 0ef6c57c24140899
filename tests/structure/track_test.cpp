// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structure/track.hpp"

#include <gtest/gtest.h>

#include "core/structure/cuts.hpp"
#include "core/structure/layers.hpp"

namespace arcbid {
namespace {

Track ring(double z, double half = 10) {
  return densified({{{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}}, true},
                   2.5);
}

TEST(Track, DensifiedAndSimplifiedAgain) {
  EXPECT_EQ(ring(0).points.size(), 32u);
  EXPECT_EQ(simplified(ring(0), 0.01).points.size(), 4u);
  EXPECT_DOUBLE_EQ(length_m(ring(0)), 80);
}

TEST(KeptClear, LeavesWhatIsClearAlone) {
  const Clearance clearance({{0, 0, 0}}, 2, -1);
  double lost_m = 0;
  const std::vector<Track> kept = kept_clear(ring(0), clearance, {2.5, 2, 1}, lost_m);
  ASSERT_EQ(kept.size(), 1u);
  EXPECT_EQ(kept[0].points, ring(0).points);
  EXPECT_EQ(lost_m, 0);
}

TEST(KeptClear, PushesAStretchAside) {
  const Clearance clearance({{10, 0.4, 0.9}}, 2, -5);  // 0.9 m beside the ring
  double lost_m = 0;
  const std::vector<Track> kept = kept_clear(ring(0), clearance, {2.5, 2, 1}, lost_m);
  ASSERT_EQ(kept.size(), 1u);
  EXPECT_TRUE(kept[0].closed);
  for (std::size_t i = 0; i < kept[0].points.size(); ++i)
    EXPECT_TRUE(
        clearance.clears(kept[0].points[i], kept[0].points[(i + 1) % kept[0].points.size()]));
}

TEST(KeptClear, OpensARingWhereNothingCanBeFlown) {
  std::vector<Vec3> wall;
  for (double x = 5; x <= 15; x += 0.25)
    for (double z = -5; z <= 5; z += 0.25) wall.emplace_back(x, 0, z);
  const Clearance clearance(wall, 2, -10);
  double lost_m = 0;
  const std::vector<Track> kept = kept_clear(ring(0), clearance, {2.5, 2, 1}, lost_m);
  ASSERT_EQ(kept.size(), 1u);  // joined over the seam
  EXPECT_FALSE(kept[0].closed);
  EXPECT_NEAR(lost_m, 4, 1.5);
}

TEST(KeptClear, GivesUpInsideASolid) {
  std::vector<Vec3> ball;
  for (double x = -3; x <= 3; x += 0.5)
    for (double y = -3; y <= 3; y += 0.5)
      for (double z = -3; z <= 3; z += 0.5) ball.emplace_back(x, y, z);
  double lost_m = 0;
  const Track line{{{-1, 0, 0}, {1, 0, 0}}, false};
  EXPECT_TRUE(kept_clear(line, Clearance(ball, 2, -10), {2.5, 2, 1}, lost_m).empty());
  EXPECT_DOUBLE_EQ(lost_m, 2);
}

TEST(Clearance, SegmentsAreCheckedBetweenTheirEnds) {
  const Clearance clearance({{0, 0, 0}}, 2, -1);
  EXPECT_TRUE(clearance.clears({-10, 2.1, 0}, {10, 2.1, 0}));
  EXPECT_FALSE(clearance.clears({-10, 1.9, 0}, {10, 1.9, 0}));
  EXPECT_FALSE(clearance.clears({-10, 5, -1.1}, {10, 5, 0}));
}

TEST(CutOpen, AtThePointsNearestToTheNeighbours) {
  const Track above{{{-20, -10, 5}, {-20, -12, 5}}, false}, below{{{20, 10, -5}}, false};
  const std::vector<Track> cut = cut_open({ring(0)}, {above}, {below}, 2.5);
  ASSERT_EQ(cut.size(), 2u);
  EXPECT_EQ(cut[0].points.front(), Vec3(-10, -10, 0));
  EXPECT_EQ(cut[0].points.back(), Vec3(10, 10, 0));
  EXPECT_EQ(cut[1].points.back(), cut[0].points.front());
  EXPECT_DOUBLE_EQ(length_m(cut[0]) + length_m(cut[1]), 80);
}

TEST(CutOpen, OnceWhereBothAreOnePointOrNeitherIs) {
  for (const std::vector<Track>& neighbours : {std::vector<Track>{}, std::vector<Track>{ring(5)}}) {
    const std::vector<Track> cut = cut_open({ring(0)}, neighbours, neighbours, 2.5);
    ASSERT_EQ(cut.size(), 1u);
    EXPECT_FALSE(cut[0].closed);
    EXPECT_EQ(cut[0].points.front(), cut[0].points.back());
    EXPECT_DOUBLE_EQ(length_m(cut[0]), 80);
  }
}

TEST(Slice, EveryPointIsInOneLayerAndLevelsSeeTopAndBottom) {
  std::vector<Vec3> mast;
  for (double z = 0; z <= 22; z += 0.5) mast.emplace_back(0, 0, z);
  CoverageSettings settings;  // D = 5
  const std::vector<Layer> layers = slice(mast, settings, -100);
  ASSERT_EQ(layers.size(), 5u);
  std::size_t points = 0;
  for (std::size_t k = 0; k < layers.size(); ++k) {
    EXPECT_NEAR(layers[k].level_m, 22 - 4.4 * (static_cast<double>(k) + 0.5), 1e-9);
    for (const Vec3& p : layers[k].points) EXPECT_LE(std::abs(p.z() - layers[k].level_m), 2.5);
    points += layers[k].points.size();
  }
  EXPECT_EQ(points, mast.size());
}

TEST(Slice, NoLevelUnderTheFloor) {
  std::vector<Vec3> mast;
  for (double z = 0; z <= 22; z += 0.5) mast.emplace_back(0, 0, z);
  const std::vector<Layer> layers = slice(mast, {}, 12);
  ASSERT_EQ(layers.size(), 3u);  // of the 12.5 m above 9.5
  EXPECT_EQ(layers.back().level_m, 12);
  EXPECT_EQ(layers.back().points.front().z(), 0);
}

}  // namespace
}  // namespace arcbid
