// SPDX-License-Identifier: GPL-3.0-or-later
#include "agent/route_planner.hpp"

#include <gtest/gtest.h>

#include <thread>

#include "tests/auction/fleet.hpp"

namespace arcbid::testing {
namespace {

/// A fleet that has agreed, and what one of it plans.
class RoutePlannerTest : public ::testing::Test {
 protected:
  void agree(TradesKind trades, std::uint32_t arcs) {
    Mission drawn = random_mission(5, 3, arcs);
    drawn.auction.trades = trades;
    mission = std::make_shared<const Mission>(drawn);
    fleet.emplace(drawn, Fleet::Link{}, 1);
    ASSERT_TRUE(fleet->run(60'000'000'000));
  }
  void plan(std::uint32_t agent) {
    planner.plan(mission, std::make_shared<StraightTransit>(), fleet->agent({agent}).tasks(),
                 *fleet->agreement({agent}), {agent});
  }
  PlannedFlight flight() {
    for (;;) {
      if (auto planned = planner.take()) return *planned;
      std::this_thread::yield();
    }
  }
  std::atomic<int> calls = 0;
  std::shared_ptr<const Mission> mission;
  std::optional<Fleet> fleet;
  RoutePlanner planner{[this] { ++calls; }};
};

TEST_F(RoutePlannerTest, PlansWhatFollowsFromTheAgreementForEveryMember) {
  agree(TradesKind::cheap, 12);
  std::vector<std::optional<AgentId>> owners;
  std::size_t flown = 0;
  for (const std::uint32_t agent : {1U, 2U, 3U}) {
    plan(agent);
    EXPECT_TRUE(planner.busy());
    const PlannedFlight planned = flight();
    EXPECT_FALSE(planner.busy());
    EXPECT_EQ(planned.view_hash, fleet->agreement({agent})->view_hash);
    if (!owners.empty()) {
      EXPECT_EQ(planned.share.owners, owners);
    }
    owners = planned.share.owners;
    for (const PathStop& stop : planned.share.path)
      EXPECT_EQ(owners[stop.task.value], AgentId{agent});
    flown += planned.share.path.size();
  }
  EXPECT_EQ(flown, owners.size());
  EXPECT_EQ(calls, 3);
}

/// A tour that would take minutes is given up as soon as nobody wants it.
TEST_F(RoutePlannerTest, ALongTourIsGivenUpToo) {
  agree(TradesKind::off, 40);
  Mission long_tours = *mission;
  long_tours.tour.iterations = 1'000'000;
  mission = std::make_shared<const Mission>(long_tours);
  plan(1);
  planner.drop();
  EXPECT_EQ(flight().view_hash, 0u);
}

TEST_F(RoutePlannerTest, WhatIsDroppedIsOfNoAgreement) {
  agree(TradesKind::full, 60);
  plan(1);
  planner.drop();
  EXPECT_EQ(flight().view_hash, 0u);
  plan(1);
  EXPECT_EQ(flight().view_hash, fleet->agreement({1})->view_hash);
}

}  // namespace
}  // namespace arcbid::testing
