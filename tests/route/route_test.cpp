// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/route/route.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "core/auction/policy.hpp"

namespace arcbid {
namespace {

Mission mission_of(std::uint32_t arcs) {
  Mission mission;
  for (std::uint32_t m = 0; m < arcs; ++m) {
    const double y = 7.0 * ((m * 5) % arcs);
    mission.arcs.push_back({{m},
                            ArcKind::outline,
                            {{{0, y, 5}, Vec3::UnitX()},
                             {{12, y, 5}, Vec3::UnitX()},
                             {{25, y + 1, 6}, Vec3::UnitY()}}});
  }
  mission.fleet = {{{1}, {-5, 0, 0}, 2.0}};
  mission.auction.split_m = 10;
  return mission;
}

struct Planned {
  Mission mission;
  TaskSet tasks;
  Route route;
};

Planned planned(std::uint32_t arcs, bool all = true) {
  Mission mission = mission_of(arcs);
  TaskSet tasks = split(mission.arcs, mission.auction.split_m, 1000);
  std::vector<PathStop> path;
  for (const Task& task : tasks.tasks)
    if (all || task.id.value % 2 == 0) path.push_back({task.id, task.arc.value % 2 == 1});
  Route route = plan_route(mission, tasks, path, mission.fleet[0], StraightTransit());
  return {std::move(mission), std::move(tasks), std::move(route)};
}

TEST(Route, IsWholeFromHomeToHome) {
  const auto [mission, tasks, route] = planned(9);
  Vec3 at = mission.fleet[0].home_m;
  double metres = 0;
  for (const RouteLeg& leg : route.legs) {
    EXPECT_EQ(leg.waypoints.front().position_m, at);
    metres += length_m(leg.waypoints);
    at = leg.waypoints.back().position_m;
  }
  EXPECT_EQ(at, mission.fleet[0].home_m);
  EXPECT_NEAR(metres, route.length_m, 1e-9);
  EXPECT_DOUBLE_EQ(route.time_s, route.length_m / 2.0);
}

/// What was bid for within an endurance is flown within it: the order of the auction is one that
/// the tour begins with.
TEST(Route, LastsNoLongerThanTheEnduranceThatWasBidWith) {
  const StraightTransit transit;
  std::size_t flown = 0;
  for (double endurance_s = 40; endurance_s < 400; endurance_s += 7) {
    Mission mission = mission_of(9);
    mission.tour.iterations = 100;
    mission.fleet[0].endurance_s = endurance_s;
    const TaskSet tasks = split(mission.arcs, mission.auction.split_m, 1000);
    for (const ScoreKind score :
         {ScoreKind::minimax, ScoreKind::minimax_long_first, ScoreKind::minisum,
          ScoreKind::independent, ScoreKind::discounted_append,
          ScoreKind::discounted_insert_warped}) {
      mission.auction.score = score;
      Bundle bundle = make_bundle(tasks, mission.fleet[0], mission.auction, transit);
      bundle.rebuild(std::vector<Belief>(tasks.tasks.size()));
      const Route route = plan_route(mission, tasks, bundle.path(), mission.fleet[0], transit);
      EXPECT_LE(route.time_s, endurance_s * (1 + 1e-9)) << name_of(score);
      flown += bundle.path().size();
    }
  }
  EXPECT_GT(flown, 1000u);
}

TEST(Route, FliesWhatWasWonAndNothingElse) {
  const auto [mission, tasks, route] = planned(6, false);
  std::map<ArcId, double> won_m, flown_m;
  for (const Task& task : tasks.tasks)
    if (task.id.value % 2 == 0) won_m[task.arc] += task.length_m();
  for (const RouteLeg& leg : route.legs)
    if (leg.arc) flown_m[*leg.arc] += std::abs(leg.to_m - leg.from_m);
  ASSERT_EQ(flown_m.size(), won_m.size());
  for (const auto& [arc, metres] : won_m) EXPECT_NEAR(flown_m[arc], metres, 1e-9);
}

TEST(Route, FliesAnArcBackwardsWithItsDistancesAndWaypointsTurned) {
  const auto [mission, tasks, route] = planned(9);
  bool backwards = false;
  for (const RouteLeg& leg : route.legs) {
    if (!leg.arc || leg.from_m < leg.to_m) continue;
    backwards = true;
    const auto forward = part(mission.arcs[leg.arc->value].waypoints, leg.to_m, leg.from_m);
    EXPECT_EQ(leg.waypoints.front().position_m, forward.back().position_m);
    EXPECT_EQ(leg.waypoints.back().position_m, forward.front().position_m);
  }
  EXPECT_TRUE(backwards) << "a back-and-forth pattern flies some arcs backwards";
}

TEST(Route, IsNeverLongerThanTheOrderTheBidsWerePricedWith) {
  for (std::uint32_t arcs = 1; arcs < 25; ++arcs) {
    const Route route = planned(arcs).route;
    EXPECT_LE(route.length_m, route.auction_order_m);
    EXPECT_LE(route.length_m, route.crsom_m);
  }
}

TEST(Route, OfNothingStaysAtHome) {
  const Mission mission = mission_of(2);
  const TaskSet tasks = split(mission.arcs, 10, 1000);
  const Route route = plan_route(mission, tasks, {}, mission.fleet[0], StraightTransit());
  EXPECT_TRUE(route.legs.empty());
  EXPECT_EQ(route.length_m, 0);
}

}  // namespace
}  // namespace arcbid
