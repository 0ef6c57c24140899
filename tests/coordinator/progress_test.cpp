// SPDX-License-Identifier: GPL-3.0-or-later
#include "coordinator/progress.hpp"

#include <gtest/gtest.h>

namespace arcbid {
namespace {

constexpr TimeNs now = 100'000'000'000;

Mission two_agents() {
  Mission mission;
  mission.fleet = {{{1}, Vec3::Zero(), 1}, {{2}, Vec3::Zero(), 1}};
  return mission;
}

StatusMessage status(std::uint32_t agent, Phase phase, std::uint64_t hash,
                     bool second_is_dead = false) {
  StatusMessage message;
  message.header = {{agent}, 1000, 5, 1, 1};
  message.phase = phase;
  message.view_hash = hash;
  message.view = {{{1}, {1000, false, 1}}, {{2}, {1000, second_is_dead, 1}}};
  return message;
}

RouteMessage route(std::uint32_t agent, std::uint64_t hash) {
  RouteMessage message;
  message.header.sender = {agent};
  message.view_hash = hash;
  return message;
}

TEST(Progress, IsCompleteWhenEveryLivingMemberIsRoutedUnderOneView) {
  Progress progress(two_agents());
  progress.heard(status(1, Phase::routed, 7), now);
  progress.heard(route(1, 7));
  progress.heard(status(2, Phase::agreed, 7), now);
  EXPECT_FALSE(progress.complete(now)) << "agent 2 has no route yet";
  progress.heard(route(2, 7));
  StatusMessage later = status(2, Phase::routed, 7);
  later.header.sequence = 6;
  progress.heard(later, now);
  EXPECT_EQ(progress.complete(now), 7u);
}

TEST(Progress, WantsTheRouteOfThisAgreementNotOfAnEarlierOne) {
  Progress progress(two_agents());
  for (const std::uint32_t agent : {1u, 2u}) {
    progress.heard(status(agent, Phase::routed, 8), now);
    progress.heard(route(agent, agent == 1 ? 8 : 7));
  }
  EXPECT_FALSE(progress.complete(now));
}

TEST(Progress, DoesNotWaitForTheDead) {
  Progress progress(two_agents());
  progress.heard(status(1, Phase::routed, 9, true), now);
  progress.heard(route(1, 9));
  EXPECT_EQ(progress.complete(now), 9u);
}

TEST(Progress, WaitsForAMemberThatWasBuriedAlive) {
  Progress progress(two_agents());
  progress.heard(status(2, Phase::auction, 0), now);
  progress.heard(status(1, Phase::routed, 9, true), now);
  progress.heard(route(1, 9));
  EXPECT_FALSE(progress.complete(now)) << "agent 2 was heard just now";
  EXPECT_EQ(progress.complete(now + 60'000'000'000), 9u);
}

TEST(Progress, SeesThatTwoCameToDifferentExchanges) {
  Progress progress(two_agents());
  RouteMessage first = route(1, 9), second = route(2, 9);
  first.owners_digest = second.owners_digest = 5;
  progress.heard(first);
  progress.heard(second);
  EXPECT_FALSE(progress.discord());
  second.owners_digest = 6;
  second.view_hash = 8;
  progress.heard(second);
  EXPECT_FALSE(progress.discord()) << "of an earlier agreement";
  second.view_hash = 9;
  progress.heard(second);
  EXPECT_EQ(progress.discord(), std::pair(AgentId{1}, AgentId{2}));
}

TEST(Progress, IgnoresAnOlderStatusThatComesLate) {
  Progress progress(two_agents());
  StatusMessage reopened = status(1, Phase::auction, 0, true);
  reopened.header.sequence = 9;
  progress.heard(route(1, 9));
  progress.heard(reopened, now);
  progress.heard(status(1, Phase::routed, 9, true), now);
  EXPECT_FALSE(progress.complete(now));
}

TEST(Progress, KnowsWhenSomebodyLacksTheMission) {
  Progress progress(two_agents());
  EXPECT_FALSE(progress.mission_wanted());
  progress.heard(status(2, Phase::waiting_for_mission, 0), now);
  EXPECT_TRUE(progress.mission_wanted());
  progress.mission_sent();
  EXPECT_FALSE(progress.mission_wanted());
}

}  // namespace
}  // namespace arcbid
