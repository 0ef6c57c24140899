// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/coverage/trim.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace arcbid {
namespace {

/// Stations a metre apart on straight arcs; each arc's height is its number, so that whoever gets
/// a piece of it knows which.
std::vector<SeenArc> random_arcs(std::mt19937& random, std::uint32_t samples) {
  std::vector<SeenArc> arcs;
  for (std::uint32_t a = 0; a < 6; ++a) {
    SeenArc arc;
    const std::uint32_t count = 5 + random() % 60;
    for (std::uint32_t k = 0; k < count; ++k) {
      arc.arc.waypoints.push_back({Vec3(k, 0, a), Vec3::UnitX()});
      arc.at_m.push_back(k);
      std::set<std::uint32_t> seen;
      for (std::uint32_t n = random() % 4; n > 0; --n) seen.insert(random() % samples);
      arc.seen.emplace_back(seen.begin(), seen.end());
    }
    arcs.push_back(arc);
  }
  return arcs;
}

TEST(Trim, NeverLosesASampleAndAlwaysSavesWay) {
  std::mt19937 random(5);
  for (int round = 0; round < 200; ++round) {
    const std::vector<SeenArc> arcs = random_arcs(random, 20 + random() % 300);
    std::set<std::uint32_t> before, after;
    double before_m = 0, after_m = 0;
    for (const SeenArc& arc : arcs) {
      before_m += length_m(arc.arc.waypoints);
      for (const Seen& seen : arc.seen) before.insert(seen.begin(), seen.end());
    }
    for (const Arc& arc : trimmed(arcs, 400, {2.0, 8.0})) {
      ASSERT_GE(arc.waypoints.size(), 2u);
      ASSERT_GE(length_m(arc.waypoints), 2.0 - 1e-9);
      after_m += length_m(arc.waypoints);
      for (const Waypoint& w : arc.waypoints) {
        const auto a = static_cast<std::size_t>(std::lround(w.position_m.z()));
        const auto k = static_cast<std::size_t>(std::lround(w.position_m.x()));
        after.insert(arcs[a].seen[k].begin(), arcs[a].seen[k].end());
      }
    }
    EXPECT_EQ(after, before);
    EXPECT_LE(after_m, before_m);
  }
}

TEST(Trim, DropsArcsEndsAndLongMiddlesThatNothingNeeds) {
  const auto arc = [](double z, std::vector<Seen> seen) {
    SeenArc result;
    for (std::size_t k = 0; k < seen.size(); ++k) {
      result.arc.waypoints.push_back({Vec3(static_cast<double>(k), 0, z), Vec3::UnitX()});
      result.at_m.push_back(static_cast<double>(k));
    }
    result.seen = std::move(seen);
    return result;
  };
  std::vector<Seen> needed(40);
  for (std::uint32_t k = 5; k < 10; ++k) needed[k] = {k};
  for (std::uint32_t k = 25; k < 30; ++k) needed[k] = {k};
  const std::vector<Arc> left = trimmed({arc(0, needed), arc(1, {{5}, {6}, {7}})}, 40, {2.0, 10.0});
  ASSERT_EQ(left.size(), 2u);
  EXPECT_EQ(left[0].waypoints.front().position_m, Vec3(5, 0, 0));
  EXPECT_EQ(left[0].waypoints.back().position_m, Vec3(9, 0, 0));
  EXPECT_EQ(left[1].waypoints.front().position_m, Vec3(25, 0, 0));
  EXPECT_EQ(left[1].waypoints.back().position_m, Vec3(29, 0, 0));
}

}  // namespace
}  // namespace arcbid
