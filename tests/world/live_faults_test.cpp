// SPDX-License-Identifier: GPL-3.0-or-later
// What happened to processes, as faults of a world.
#include <gmock/gmock.h>

#include "core/base/error.hpp"
#include "sim/world/live_run.hpp"

namespace arcbid::testing {
namespace {

using ::testing::Contains;
using ::testing::Not;
using ::testing::UnorderedElementsAre;

using Kind = AgentFaultKind;
constexpr TimeNs second = 1'000'000'000, lease = second / 2;

AgentFault fault(std::uint32_t agent, Kind kind, TimeNs at_ns, std::optional<TimeNs> for_ns) {
  AgentFault out;
  out.agent = {agent};
  out.kind = kind;
  out.at_ns = at_ns;
  out.for_ns = for_ns;
  return out;
}

LiveLife life(std::uint32_t agent, TimeNs born_ns, TimeNs last_ns, const std::string& ended_by) {
  return {{agent}, born_ns, last_ns, ended_by, false};
}

/// Two agents that live from 1 s to 9 s.
LiveRun quiet() {
  LiveRun run;
  run.mission.fleet = {{{1}, {0, 0, 0}, 1}, {{2}, {0, 0, 0}, 1}};
  run.mission.auction.lease_ns = lease;
  run.lives = {life(1, second, 9 * second, "coordinator"),
               life(2, second + 1, 9 * second, "coordinator")};
  return run;
}

TEST(LiveFaults, LetAgentsBeBornWhenTheyWere) {
  EXPECT_THAT(faults_of(quiet()).agents, UnorderedElementsAre(fault(1, Kind::late, 0, second),
                                                              fault(2, Kind::late, 0, second + 1)));
}

TEST(LiveFaults, KillAgentsWhenTheyWereKilledAndBringThemBackWhenTheyHadTheMissionAgain) {
  LiveRun run = quiet();
  run.schedule.agents = {fault(2, Kind::crash, 2 * second, second)};  // what was to be
  run.lives[1] = life(2, second, 2 * second, "");
  run.lives.push_back(life(2, 4 * second, 9 * second, "signal"));
  run.acts = {{2 * second + 7, {2}, "kill"}, {3 * second, {2}, "start"}};
  EXPECT_THAT(faults_of(run).agents,
              UnorderedElementsAre(fault(1, Kind::late, 0, second), fault(2, Kind::late, 0, second),
                                   fault(2, Kind::crash, 2 * second + 7, 2 * second - 7)));
}

TEST(LiveFaults, KnowDeathsThatNobodyAskedFor) {
  LiveRun run = quiet();
  run.lives[1] = life(2, second, 5 * second, "");
  EXPECT_THAT(faults_of(run).agents, Contains(fault(2, Kind::crash, 5 * second, {})));
  run.lives[1].ended_by = "signal";  // somebody ended it, long before the rest
  EXPECT_THAT(faults_of(run).agents, Contains(fault(2, Kind::crash, 5 * second, {})));
}

TEST(LiveFaults, TakeTheRunsEndForNoDeath) {
  LiveRun run = quiet();
  for (LiveLife& one : run.lives) one.ended_by = "signal";
  run.lives[1].last_ns -= lease;  // nobody could miss it
  EXPECT_THAT(faults_of(run).agents,
              Not(Contains(::testing::Field(&AgentFault::kind, Kind::crash))));
}

TEST(LiveFaults, TakeAPauseForGoodForADeath) {
  LiveRun run = quiet();
  run.acts = {{2 * second, {1}, "pause"}, {3 * second, {1}, "resume"}, {4 * second, {2}, "pause"}};
  EXPECT_THAT(faults_of(run).agents, UnorderedElementsAre(fault(1, Kind::late, 0, second),
                                                          fault(1, Kind::pause, 2 * second, second),
                                                          fault(2, Kind::late, 0, second + 1),
                                                          fault(2, Kind::crash, 4 * second, {})));
}

TEST(LiveFaults, LetWhoNeverHadTheMissionSayNothing) {
  LiveRun run = quiet();
  run.lives.pop_back();
  EXPECT_THAT(faults_of(run).agents, Contains(fault(2, Kind::crash, 0, {})));
}

TEST(LiveFaults, KeepASecondProcessApart) {
  LiveRun run = quiet();
  run.lives.push_back({{2}, 3 * second, 4 * second, "", true});
  EXPECT_THAT(
      faults_of(run).agents,
      UnorderedElementsAre(fault(1, Kind::late, 0, second), fault(2, Kind::late, 0, second + 1),
                           fault(2, Kind::twin, 3 * second, second)));
}

TEST(LiveFaults, SpoilMessagesInEveryLifeAndOverBidWhereAProcessEndedOfIt) {
  LiveRun run = quiet();
  AgentFault spoils = fault(2, Kind::malformed, 0, {});
  spoils.malformation = Malformation::wrong_tasks;
  AgentFault over = fault(1, Kind::malformed, 2 * second, {});
  over.malformation = Malformation::over_bid;
  run.schedule.agents = {spoils, over};
  run.lives[0] = life(1, second, 2 * second + 5, "fault");
  const FaultSchedule faults = faults_of(run);
  spoils.at_ns = second + 1;
  EXPECT_THAT(faults.agents, Contains(spoils));
  over.at_ns = 2 * second + 5;
  EXPECT_THAT(faults.agents, Contains(over));
  run.lives[0].ended_by = "coordinator";
  EXPECT_THAT(faults_of(run).agents, Not(Contains(over))) << "it never came to it";
}

TEST(LiveFaults, EndThoseOfLinksWithTheRunAndKeepClocks) {
  LiveRun run = quiet();
  LinkFault lossy;
  lossy.loss = 0.3;
  run.schedule.links = {lossy};
  const AgentFault clock = fault(1, Kind::clock, 0, {});
  run.schedule.agents = {clock};
  EXPECT_EQ(faults_of(run).until_ns, 9 * second);
  EXPECT_EQ(faults_of(run).links, run.schedule.links);
  EXPECT_THAT(faults_of(run).agents, Contains(clock));
  run.schedule.until_ns = 3 * second;
  EXPECT_EQ(faults_of(run).until_ns, 3 * second);
}

TEST(LiveFaults, RefuseARunThatNobodySurvived) {
  LiveRun run = quiet();
  run.acts = {{2 * second, {1}, "kill"}, {3 * second, {2}, "kill"}};
  EXPECT_THROW(faults_of(run), InputError);
}

}  // namespace
}  // namespace arcbid::testing
