// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/base/error.hpp"
#include "core/io/mission/mission_plan.hpp"

namespace arcbid {
namespace {

TEST(PlaceFleet, SpreadsUavsAlongTheLongerSideOnTheGround) {
  const FleetConfig fleet{.agents = 4, .speed_mps = 2, .endurance_s = {}, .uavs = {}};
  const auto uavs = place_fleet(fleet, {-10, -40, 1}, {10, 40, 30}, 8);
  ASSERT_EQ(uavs.size(), 4u);
  for (std::uint32_t i = 0; i < 4; ++i) {
    EXPECT_EQ(uavs[i].id.value, i + 1);
    EXPECT_EQ(uavs[i].home_m, Vec3(-18, -30 + 20.0 * i, 1));
    EXPECT_EQ(uavs[i].speed_mps, 2);
  }
}

TEST(PlaceFleet, GivesEveryUavTheFleetsLimits) {
  const FleetConfig fleet{.agents = 2, .endurance_s = 900, .payload = Payload::camera, .uavs = {}};
  for (const Uav& uav : place_fleet(fleet, {-10, -40, 1}, {10, 40, 30}, 8)) {
    EXPECT_EQ(uav.endurance_s, 900);
    EXPECT_EQ(uav.payload, Payload::camera);
  }
}

TEST(PlaceFleet, KeepsHomesThatWereGiven) {
  const FleetConfig fleet{.agents = 2,
                          .speed_mps = 1,
                          .endurance_s = {},
                          .uavs = {{{7}, {1, 2, 3}, 4}, {{3}, {5, 6, 7}, 8}}};
  const auto uavs = place_fleet(fleet, {0, 0, 0}, {9, 9, 9}, 5);
  ASSERT_EQ(uavs.size(), 2u);
  EXPECT_EQ(uavs[0].id.value, 3u);
  EXPECT_EQ(uavs[1].home_m, Vec3(1, 2, 3));
}

TEST(PlanMission, IsTheSameBitForBitWhenMadeAgain) {
  const Config config;
  EXPECT_EQ(digest(plan_mission(config, 5).mission), digest(plan_mission(config, 5).mission));
  EXPECT_NE(digest(plan_mission(config, 5).mission), digest(plan_mission(config, 6).mission));
}

TEST(PlanMission, AsksForThePayloadOfItsSensor) {
  Config config;
  for (const Arc& arc : plan_mission(config, 1).mission.arcs)
    EXPECT_EQ(arc.payload, Payload::lidar);
  config.coverage.sensor = camera_preset();
  for (const Arc& arc : plan_mission(config, 1).mission.arcs)
    EXPECT_EQ(arc.payload, Payload::camera);
}

std::size_t warnings_of(const Config& config, const std::string& text) {
  std::size_t count = 0;
  for (const std::string& line : plan_mission(config, 1).warnings)
    count += line.find(text) != std::string::npos;
  return count;
}

TEST(PlanMission, SaysWhatNobodyCouldFlyAlone) {
  Config config;
  EXPECT_EQ(warnings_of(config, "no bidder"), 0u);
  config.fleet.endurance_s = 10000;
  EXPECT_EQ(warnings_of(config, "no bidder"), 0u);
  config.fleet.endurance_s = 20;
  EXPECT_GT(warnings_of(config, "s, best endurance 20.0 s (agent "), 0u);
  config.fleet.payload = Payload::camera;
  const std::size_t arcs = plan_mission(config, 1).mission.arcs.size();
  EXPECT_EQ(warnings_of(config, "no bidder: needs a lidar, nobody carries one"), arcs);
}

TEST(PlanMission, PublishesWhatIsInTheWay) {
  const Mission mission = plan_mission(Config{}, 1).mission;
  EXPECT_FALSE(mission.airspace.empty());
  EXPECT_EQ(mission.airspace.low_m.z(), 3);
  EXPECT_LT(mission.airspace.runs.size(), 10'000u);
}

TEST(PlanMission, RefusesAHomeFromWhichNobodyCanRise) {
  Config config;
  config.fleet.uavs = {{{7}, {-20, 0, 0}, 1}, {{3}, {30, 0, 12.5}, 1}};
  try {
    plan_mission(config, 1);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()),
              "fleet.uavs[1].home_m: from (30, 0, 12.5) a UAV cannot rise to z = 3 and fly on with "
              "coverage.safety_m 2 between it and the structure; legal is a place with that and "
              "some 0.5 m more around it");
  }
}

TEST(PlanMission, RefusesBundlesThatCannotHoldAllTasks) {
  Config config;
  config.auction.bundle_limit = 1;
  try {
    plan_mission(config, 1);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("auction.bundle_limit: 1"), std::string::npos);
  }
}

TEST(PlanMission, NumbersArcsAndFleetAsTheAuctionExpects) {
  const Mission mission = plan_mission(Config{}, 1).mission;
  ASSERT_FALSE(mission.arcs.empty());
  for (std::uint32_t m = 0; m < mission.arcs.size(); ++m) EXPECT_EQ(mission.arcs[m].id.value, m);
  for (std::size_t i = 1; i < mission.fleet.size(); ++i)
    EXPECT_LT(mission.fleet[i - 1].id, mission.fleet[i].id);
}

}  // namespace
}  // namespace arcbid
