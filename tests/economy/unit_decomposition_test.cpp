// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/coverage/unit_decomposition.hpp"

#include <gmock/gmock.h>

#include "core/base/error.hpp"
#include "core/coverage/greedy_cover.hpp"
#include "tests/structure/arc_laws.hpp"

namespace arcbid {
namespace {

using testing::ElementsAre;

TEST(GreedyCover, TakesWhatAddsMostAndNothingInVain) {
  EXPECT_THAT(greedy_cover({{0, 1}, {1, 2, 3}, {3, 4}, {0}, {2}}, 5), ElementsAre(1, 0, 2));
  EXPECT_THAT(greedy_cover({{}, {7}, {7}}, 8), ElementsAre(1));
  // The second adds little once the first is taken.
  EXPECT_THAT(greedy_cover({{0, 1, 2, 3}, {0, 1, 2, 4}, {5, 6}}, 7), ElementsAre(0, 2, 1));
  EXPECT_TRUE(greedy_cover({}, 3).empty());
}

Structure wall() {
  return box_mesh({-15, -0.2, 0}, {15, 0.2, 12});
}

CoverageSettings with_threads(unsigned threads) {
  CoverageSettings settings;
  settings.threads = threads;
  return settings;
}

TEST(UnitDecomposition, FliesInTheMiddlesOfCellsAtASafeDistance) {
  const CoverageSettings settings = with_threads(2);
  const UnitDecomposition units = unit_decomposition(wall(), settings);
  ASSERT_FALSE(units.viewpoints.empty());
  const Vec3 first = units.viewpoints.front().position_m;
  for (const Waypoint& w : units.viewpoints) {
    const Vec3 box = w.position_m.cwiseMax(Vec3(-15, -0.2, 0)).cwiseMin(Vec3(15, 0.2, 12));
    EXPECT_GE((w.position_m - box).norm(), settings.safety_m);
    EXPECT_LE((w.position_m - box).norm(), settings.sensor.range_m);
    EXPECT_GE(w.position_m.z(), settings.ground_clearance_m - 1e-9);
    EXPECT_NEAR(w.look.norm(), 1, 1e-9);
    const Vec3 cells = (w.position_m - first) / (settings.spacing_m / 2);
    EXPECT_NEAR((cells - cells.array().round().matrix()).norm(), 0, 1e-6);
  }
}

TEST(UnitDecomposition, KeepsFewOfTheCellsAndSeesTheWallsOutside) {
  const UnitDecomposition units = unit_decomposition(wall(), with_threads(2));
  EXPECT_LT(units.viewpoints.size(), units.cells / 2);
  EXPECT_GT(units.covered, units.samples * 45 / 100);  // the insides are half of all
  EXPECT_LE(units.covered, units.samples / 2);
}

TEST(UnitDecomposition, StaysOutOfRoomsWithoutADoor) {
  const UnitDecomposition units =
      unit_decomposition(box_mesh({-8, -8, 0}, {8, 8, 16}), with_threads(2));
  ASSERT_FALSE(units.viewpoints.empty());
  for (const Waypoint& w : units.viewpoints)
    EXPECT_TRUE(w.position_m.head<2>().cwiseAbs().maxCoeff() > 8 || w.position_m.z() > 16);
}

TEST(UnitDecomposition, IsTheSameForAnyNumberOfThreads) {
  const auto one = unit_decomposition(wall(), with_threads(1));
  const auto two = unit_decomposition(wall(), with_threads(2));
  ASSERT_EQ(one.viewpoints.size(), two.viewpoints.size());
  for (std::size_t k = 0; k < one.viewpoints.size(); ++k) {
    EXPECT_EQ(one.viewpoints[k].position_m, two.viewpoints[k].position_m);
    EXPECT_EQ(one.viewpoints[k].look, two.viewpoints[k].look);
  }
}

TEST(UnitDecomposition, RefusesWhatItCannotDivide) {
  EXPECT_THROW(unit_decomposition({}, {}), InputError);
  CoverageSettings settings;
  settings.spacing_m = 0.02;
  EXPECT_THROW(unit_decomposition(wall(), settings), InputError);
}

}  // namespace
}  // namespace arcbid
