// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/replay/what_if.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>

#include "core/base/error.hpp"
#include "tests/auction/fleet.hpp"

namespace arcbid {
namespace {

using ::testing::HasSubstr;

constexpr TimeNs s = 1'000'000'000;

WorldSpec world_of_four() {
  WorldSpec world;
  world.seed = 1;
  world.mission = testing::random_mission(6, 4, 8);
  world.latency_ns = {1'000'000, 5'000'000};
  return world;
}
AgentFault crash(std::uint32_t agent, TimeNs at_ns, std::optional<TimeNs> for_ns = {}) {
  AgentFault fault;
  fault.agent = {agent};
  fault.at_ns = at_ns;
  fault.for_ns = for_ns;
  return fault;
}

TEST(WhatIf, LeavesEverythingAsItWasWhereNothingIsSaid) {
  const WorldSpec world = world_of_four();
  EXPECT_TRUE(OtherRules{}.none());
  EXPECT_EQ(digest(under({}, world).mission), digest(world.mission));
}

TEST(WhatIf, TellsTheWinnersOfAWorld) {
  const WorldResult result = run_world(world_of_four());
  ASSERT_TRUE(result.agreed);
  ASSERT_FALSE(result.winners.empty());
  for (const Belief& winner : result.winners) EXPECT_TRUE(winner.winner);
  EXPECT_GT(result.total_length_m, 0);
}

TEST(WhatIf, GivesNothingToWhomIsLeftOut) {
  OtherRules rules;
  rules.without = {{3}};
  WorldSpec world = world_of_four();
  world.faults.agents.push_back(crash(3, s, s));
  const WorldSpec other = under(rules, world);
  EXPECT_EQ(other.mission.fleet.size(), 3u);
  EXPECT_TRUE(other.faults.agents.empty());
  const WorldResult was = run_world(world_of_four()), is = run_world(other);
  ASSERT_TRUE(is.agreed);
  std::size_t had = 0;
  for (const Belief& winner : was.winners) had += winner.winner == AgentId{3} ? 1 : 0;
  for (const Belief& winner : is.winners) EXPECT_NE(winner.winner, AgentId{3});
  EXPECT_GT(had, 0u);
  EXPECT_GE(owners_changed(was, is), had);
  EXPECT_EQ(owners_changed(was, was), 0u);
}

TEST(WhatIf, HoldsEveryAgentToTheBundleLimit) {
  OtherRules rules;
  rules.bundle_limit = 1;
  const WorldResult is = run_world(under(rules, world_of_four()));
  ASSERT_TRUE(is.agreed);
  std::map<AgentId, int> tasks;
  for (const Belief& winner : is.winners)
    if (winner.winner) ++tasks[*winner.winner];
  ASSERT_EQ(tasks.size(), 4u);
  for (const auto& [agent, count] : tasks) EXPECT_EQ(count, 1) << agent.value;
}

TEST(WhatIf, LosesMessagesUntilThereIsCalm) {
  OtherRules rules;
  rules.loss = 0.3;
  const WorldSpec other = under(rules, world_of_four());
  ASSERT_EQ(other.faults.links.size(), 1u);
  EXPECT_EQ(other.faults.links[0].loss, 0.3);
  EXPECT_TRUE(other.faults.until_ns);
  EXPECT_TRUE(run_world(other).agreed);
}

TEST(WhatIf, LosesMessagesAlsoAfterTheRunsOwnFaults) {
  OtherRules rules;
  rules.loss = 0.3;
  WorldSpec world = world_of_four();
  world.faults.links.emplace_back().cut = true;
  world.faults.until_ns = s / 10;
  const WorldSpec other = under(rules, world);
  ASSERT_EQ(other.faults.links.size(), 2u);
  EXPECT_EQ(other.faults.links[0].when.end_ns, s / 10) << "what ended then still does";
  EXPECT_GT(*other.faults.until_ns, s);
  const WorldResult was = run_world(world), is = run_world(other);
  ASSERT_TRUE(was.agreed && is.agreed);
  EXPECT_NE(was.digest, is.digest);
}

TEST(WhatIf, LetsTheOneLiveWhoDiedLast) {
  WorldSpec world = world_of_four();
  world.faults.agents = {crash(2, 1 * s, s), crash(2, 5 * s), crash(3, 2 * s)};
  const auto other = with_alive(world, {2}, 8 * s);
  ASSERT_TRUE(other);
  ASSERT_EQ(other->faults.agents.size(), 2u);
  EXPECT_EQ(other->faults.agents[0].at_ns, 1 * s);
  EXPECT_EQ(other->faults.agents[1].agent, AgentId{3});
  EXPECT_FALSE(with_alive(world, {4}, 8 * s));
  EXPECT_FALSE(with_alive(world, {2}, s / 2)) << "it had not died yet";
  const WorldResult is = run_world(*other);
  ASSERT_TRUE(is.agreed);
  EXPECT_TRUE(std::any_of(is.winners.begin(), is.winners.end(),
                          [](const Belief& winner) { return winner.winner == AgentId{2}; }));
}

TEST(WhatIf, RefusesWhatLeavesNobody) {
  const auto message = [](const OtherRules& rules, const WorldSpec& world) -> std::string {
    try {
      under(rules, world);
      return "";
    } catch (const InputError& error) {
      return error.what();
    }
  };
  OtherRules nobody, stranger, many, dead;
  nobody.without = {{1}, {2}, {3}, {4}};
  stranger.without = {{9}};
  many.agents = 7;
  dead.agents = 1;
  WorldSpec dying = world_of_four();
  dying.faults.agents = {crash(1, s)};
  EXPECT_THAT(message(nobody, world_of_four()), HasSubstr("nobody would be alive"));
  EXPECT_THAT(message(stranger, world_of_four()), HasSubstr("--without 9"));
  EXPECT_THAT(message(many, world_of_four()), HasSubstr("--agents 7"));
  EXPECT_THAT(message(dead, dying), HasSubstr("nobody would be alive"));
}

}  // namespace
}  // namespace arcbid
