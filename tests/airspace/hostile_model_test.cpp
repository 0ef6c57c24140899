// SPDX-License-Identifier: GPL-3.0-or-later
// Models that no coordinator makes are refused before anything is built from them.
#include <gtest/gtest.h>

#include <limits>

#include "core/airspace/runs.hpp"
#include "tests/airspace/scenes.hpp"

namespace arcbid {
namespace {

Airspace small() {
  Airspace a;
  a.cell_m = 0.5;
  a.cells = {4, 3, 2};
  a.runs = {24};
  return a;
}

struct Case {
  const char* name;
  void (*spoil)(Airspace&);
  const char* reason;
};
void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name;
}

class Hostile : public testing::TestWithParam<Case> {};

TEST_P(Hostile, IsRefusedWithAReason) {
  Airspace airspace = small();
  ASSERT_EQ(unsound(airspace), std::nullopt);
  GetParam().spoil(airspace);
  EXPECT_EQ(unsound(airspace), GetParam().reason);
}

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

INSTANTIATE_TEST_SUITE_P(
    All, Hostile,
    testing::Values(
        Case{"TooFew", [](Airspace& a) { a.runs = {23}; }, "runs: 23 cells instead of 24"},
        Case{"TooMany",
             [](Airspace& a) {
               a.runs = {23, 2};
             },
             "runs: more than the 24 cells at byte 1"},
        Case{"None", [](Airspace& a) { a.runs = {}; }, "runs: 0 cells instead of 24"},
        Case{"EmptyRun",
             [](Airspace& a) {
               a.runs = {12, 0, 12};
             },
             "runs: an empty run at byte 1"},
        Case{"Unfinished",
             [](Airspace& a) {
               a.runs = {12, 140};
             },
             "runs: no number at byte 1"},
        Case{"Overflow",
             [](Airspace& a) { a.runs = {255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 1}; },
             "runs: no number at byte 0"},
        Case{"Flat", [](Airspace& a) { a.cells[2] = 0; }, "cells: 0 along an axis"},
        Case{"Huge",
             [](Airspace& a) {
               a.cells = {4'000'000'000, 4'000'000'000, 4'000'000'000};
             },
             "cells: 4000000000 along an axis"},
        Case{"HugeTogether",
             [](Airspace& a) {
               a.cells = {60'000, 60'000, 2};
             },
             "cells: more than 8000000"},
        Case{"EmptyButNot", [](Airspace& a) { a.cells[0] = 0; },
             "cells: none, but there are others"},
        Case{"NoCell", [](Airspace& a) { a.cell_m = 0; }, "cell_m: 0"},
        Case{"NanCell", [](Airspace& a) { a.cell_m = kNan; }, "cell_m: nan"},
        Case{"Nowhere", [](Airspace& a) { a.low_m.y() = kNan; }, "low_m: not a place"},
        Case{"FarAway", [](Airspace& a) { a.low_m.x() = 1e300; }, "low_m: not a place"},
        Case{"AccessOfOne",
             [](Airspace& a) {
               a.accesses.push_back({{0}, 0, {{Vec3(0, 0, 0)}}});
             },
             "accesses[0]: fewer than two points"},
        Case{"AccessNowhere",
             [](Airspace& a) {
               a.accesses.push_back({{0}, 0, {{Vec3(0, 0, 0)}, {Vec3(0, kNan, 0)}}});
             },
             "accesses[0]: not a place"}),
    [](const auto& each) { return each.param.name; });

/// Sound but nonsense: legs come out, some straight through what is closed, and nothing breaks.
TEST(Nonsense, DoesNotBreakLegs) {
  Random random(5);
  for (int n = 0; n < 60; ++n) {
    Airspace airspace;
    airspace.cell_m = 1;
    airspace.cells = {9, 8, 7};
    Cells cells(9 * 8 * 7);
    const double share = real(random, 0, 1);
    for (auto& cell : cells) cell = real(random, 0, 1) < share;
    airspace.runs = encode_runs(cells, airspace.cells);
    ASSERT_EQ(unsound(airspace), std::nullopt);
    ASSERT_EQ(decode_runs(airspace), cells);
    std::vector<Vec3> places;
    for (int k = 0; k < 12; ++k)
      places.emplace_back(real(random, -3, 12), real(random, -3, 12), real(random, -1, 9));
    const ObstacleTransit transit(airspace, {}, places, 1);
    for (const Vec3& from : places)
      for (const Vec3& to : places) {
        const auto way = transit.way(from, to);
        ASSERT_EQ(way.front(), from);
        ASSERT_EQ(way.back(), to);
        ASSERT_EQ(transit.length_m(from, to), way_length_m(way));
      }
  }
}

/// Small steps against leaps.
TEST(Sight, IsWhatSmallStepsSee) {
  Random random(9);
  for (int n = 0; n < 20; ++n) {
    Airspace airspace;
    airspace.cell_m = 1;
    airspace.cells = {20, 15, 10};
    Cells cells(20 * 15 * 10, 1);
    for (int k = 0; k < 12; ++k) cells[random() % cells.size()] = 0;
    airspace.runs = encode_runs(cells, airspace.cells);
    const FreeGrid grid(airspace);
    for (int k = 0; k < 200; ++k) {
      const Vec3 a(real(random, -5, 25), real(random, -5, 20), real(random, 0, 13));
      const Vec3 b(real(random, -5, 25), real(random, -5, 20), real(random, 0, 13));
      bool free = true;
      for (int s = 0; s <= 4000; ++s) free = free && grid.free(Vec3(a + s / 4000.0 * (b - a)));
      if (grid.sees(a, b)) {
        ASSERT_TRUE(free);
      } else if (free) {
        // Only a corner may be touched between two steps.
        int touched = 0;
        for (int s = 0; s <= 400'000 && touched == 0; ++s)
          touched += !grid.free(Vec3(a + s / 400'000.0 * (b - a)));
        ASSERT_GT(touched, 0);
      }
    }
  }
}

}  // namespace
}  // namespace arcbid
