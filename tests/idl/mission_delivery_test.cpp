// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <thread>

#include "tests/idl/bus_fixture.hpp"
#include "tests/idl/equal.hpp"
#include "tests/idl/samples.hpp"

namespace arcbid {
namespace {

/// 110,000 waypoints: 5.3 MB.
Mission large_mission() {
  return samples::mission(1100, 100);
}

TEST_F(BusTest, LargeMissionReachesALateJoiner) {
  const Mission mission = large_mission();
  const auto boss = coordinator();
  boss->publish(mission);
  EXPECT_GT(boss->counters().bytes_sent, 5'000'000u);
  const auto start = Clock::now();
  const auto late = agent(1);
  const auto got = next<Mission>(*late);
  ASSERT_TRUE(got);
  std::printf("5 MB to a late joiner: %.2f s after it started\n", seconds_since(start));
  EXPECT_TRUE(same(*got, mission));
}

TEST_F(BusTest, LargeMissionReachesAWholeFleet) {
  const Mission mission = large_mission();
  const auto boss = coordinator();
  std::vector<std::unique_ptr<Bus>> agents;
  for (std::uint32_t id = 1; id <= 4; ++id) agents.push_back(agent(id));
  ASSERT_TRUE(matched(*boss, 4));
  const auto start = Clock::now();
  boss->publish(mission);
  const double published_s = seconds_since(start);
  for (const auto& bus : agents) {
    const auto got = next<Mission>(*bus);
    ASSERT_TRUE(got);
    EXPECT_TRUE(same(*got, mission));
  }
  std::printf("5 MB to 4 agents: published in %.3f s, all have it after %.2f s\n", published_s,
              seconds_since(start));
}

TEST_F(BusTest, ALateJoinerGetsOnlyTheNewestMission) {
  const auto boss = coordinator();
  Mission mission = samples::mission();
  boss->publish(mission);
  mission.id = 78;
  boss->publish(mission);
  const auto late = agent(1);
  const auto got = next<Mission>(*late);
  ASSERT_TRUE(got);
  EXPECT_EQ(got->id, 78u);
  EXPECT_FALSE(next<Mission>(*late, 300ms));
}

}  // namespace
}  // namespace arcbid
