// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/arcs/mission_misfit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace arcbid {
namespace {

Mission sound() {
  Mission mission;
  mission.fleet = {{{4}, {0, 0, 0}, 1}, {{9}, {5, 0, 0}, 1}};
  mission.arcs = {{{0}, ArcKind::outline, {{{0, 0, 0}, {1, 0, 0}}, {{9, 0, 0}, {1, 0, 0}}}}};
  return mission;
}

TEST(MisfitMission, LetsPassOneThatCanBeFlown) {
  EXPECT_EQ(misfit(sound()), std::nullopt);
}

TEST(MisfitMission, NamesWhatCannotBe) {
  const auto problem = [](const std::function<void(Mission&)>& damage) {
    Mission mission = sound();
    damage(mission);
    return misfit(mission).value_or("");
  };
  const std::string no_line = "arc 0 is no line of waypoints";
  EXPECT_EQ(problem([](Mission& m) { m.arcs[0].waypoints[1].position_m.setZero(); }), no_line);
  EXPECT_EQ(problem([](Mission& m) { m.arcs[0].waypoints[1].position_m.x() = NAN; }), no_line);
  EXPECT_EQ(problem([](Mission& m) { m.arcs[0].waypoints[1].position_m.x() = 1e300; }), no_line);
  EXPECT_EQ(problem([](Mission& m) { m.arcs[0].waypoints.pop_back(); }), no_line);
  EXPECT_EQ(problem([](Mission& m) { m.arcs[0].id = {7}; }), no_line);
  EXPECT_EQ(problem([](Mission& m) { m.fleet[1].id = {4}; }), "agent 2 of its fleet is none");
  EXPECT_EQ(problem([](Mission& m) { m.fleet[0].id = {0}; }), "agent 1 of its fleet is none");
  EXPECT_EQ(problem([](Mission& m) { m.fleet[0].speed_mps = 0; }), "agent 1 of its fleet is none");
  for (const double endurance_s : {0.0, -1.0, double(NAN), double(INFINITY)})
    EXPECT_EQ(problem([=](Mission& m) { m.fleet[1].endurance_s = endurance_s; }),
              "agent 2 of its fleet is none");
  EXPECT_EQ(problem([](Mission& m) { m.fleet[1].speed_mps = INFINITY; }),
            "agent 2 of its fleet is none");
  EXPECT_EQ(problem([](Mission& m) { m.arcs[0].waypoints[1].look.z() = NAN; }), no_line);
  EXPECT_EQ(problem([](Mission& m) { m.fleet.clear(); }), "it has no arcs or no fleet");
  const std::vector<AccessPoint> way{{{0, 0, 0}}, {{0, 1, 0}}};
  EXPECT_EQ(problem([&](Mission& m) { m.airspace.accesses = {{{0}, 1, way}}; }), "");
  EXPECT_EQ(problem([&](Mission& m) {
              m.airspace.accesses = {{{1}, 0, way}};
            }),
            "an access of its airspace leads to no waypoint of arc 1");
  EXPECT_EQ(problem([&](Mission& m) {
              m.airspace.accesses = {{{0}, 2, way}};
            }),
            "an access of its airspace leads to no waypoint of arc 0");
  EXPECT_EQ(problem([](Mission& m) { m.auction.max_tasks = 1 << 30; }), "max_tasks is 1073741824");
  EXPECT_EQ(problem([](Mission& m) { m.auction.split_m = -1; }), "split_m is -1");
  EXPECT_EQ(problem([](Mission& m) { m.auction.split_m = INFINITY; }), "split_m is inf");
  EXPECT_EQ(problem([](Mission& m) { m.auction.discount_per_s = 0; }), "discount_per_s is 0");
  EXPECT_EQ(problem([](Mission& m) { m.auction.discount_per_s = INFINITY; }),
            "discount_per_s is inf");
  EXPECT_EQ(problem([](Mission& m) { m.auction.tick_ns = 0; }), "tick_ns is 0");
  EXPECT_EQ(problem([](Mission& m) { m.auction.lease_ns = -3; }), "lease_ns is -3");
  EXPECT_EQ(problem([](Mission& m) { m.auction.barrier_ns = -1; }), "barrier_ns is -1");
}

}  // namespace
}  // namespace arcbid
