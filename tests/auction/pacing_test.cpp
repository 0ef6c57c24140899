// SPDX-License-Identifier: GPL-3.0-or-later
// When a round is over: as soon as all in reach have spoken, or after a tick.
#include <gmock/gmock.h>

#include "tests/auction/agent_fixture.hpp"

namespace arcbid::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Not;

TEST_F(AgentTest, DecidesWhenAllThatArrivedWasHeard) {
  start();
  now = second;
  EXPECT_FALSE(hear(bid(claims(first, 1, {{{0}, -0.5}}))).decision);
  EXPECT_FALSE(hear(bid(claims(first, 2, {{{1}, -0.5}}))).decision);
  EXPECT_EQ(wake_ns, now);
  const Update update = tick();
  ASSERT_TRUE(update.decision);
  EXPECT_TRUE(update.decision->changed);
  EXPECT_EQ(update.decision->key, agent->view().key(at_self));
  EXPECT_EQ(agent->winners()[1].winner, first);
}

TEST_F(AgentTest, DecidesAgainWhenEverybodyHasSpokenSince) {
  start();
  now = second;
  hear(bid(claims(first, 1, {{{0}, -0.5}})));
  ASSERT_TRUE(tick().decision);
  now += 1000;
  hear(bid(claims(first, 2, {{{1}, -0.5}})));
  EXPECT_GT(wake_ns, now) << "the third has not spoken yet";
  EXPECT_FALSE(tick().decision);
  now += 1000;
  hear(status(third));
  EXPECT_EQ(wake_ns, now);
  EXPECT_TRUE(tick().decision);
}

TEST_F(AgentTest, DecidesAfterATickWhereSomebodyInReachIsSilent) {
  start();
  now = second;
  hear(bid(claims(first, 1, {{{0}, -0.5}})));
  ASSERT_TRUE(tick().decision);
  const TimeNs decided_ns = now;
  now += 1000;
  hear(bid(claims(first, 2, {{{1}, -0.5}})));
  EXPECT_EQ(wake_ns, decided_ns + mission->auction.tick_ns);
  now = wake_ns - 1;
  EXPECT_FALSE(tick().decision);
  now += 1;
  EXPECT_TRUE(tick().decision);
}

TEST_F(AgentTest, DoesNotWaitForWhoeverHoldsAllAndHasNothingToSay) {
  start();
  now = second;
  hear(bid(claims(first, 1, {{{0}, -0.5}})));
  ASSERT_TRUE(tick().decision);
  hear(bid(claims(first, 2, {{{1}, -0.5}})));
  hear(status(third));  // holds everything; spoke at the moment of the decision, not after it
  now += 1000;
  EXPECT_FALSE(tick().decision) << "the first has not spoken since either";
  hear(bid(claims(first, 3, {{{1}, -0.4}})));
  StatusMessage lacking = status(third);
  EXPECT_EQ(wake_ns, second + mission->auction.tick_ns) << "the third lacks the newest bid";
  now += 1000;
  hear(lacking);
  EXPECT_TRUE(tick().decision);
}

TEST_F(AgentTest, DoesNotWaitForWhoeverIsOutOfReach) {
  start();
  now = mission->auction.lease_ns / 2;
  hear(bid(claims(first, 1, {{{0}, -0.5}})));
  StatusMessage relayed = status(first);
  relayed.heartbeats[at_third].heartbeat = {life(third), 1000};
  hear(relayed);  // lives, but has not been heard here since the start
  now += mission->auction.lease_ns / 2 + 2;
  hear(bid(claims(first, 2, {{{1}, -0.5}})));
  ASSERT_TRUE(tick().decision);
  now += 1000;
  hear(bid(claims(first, 3, {{{0}, -0.5}})));
  EXPECT_TRUE(tick().decision);
}

TEST_F(AgentTest, SaysThatItIsReadyWhenAllHaveAnsweredItsBid) {
  start();
  now = second;
  hear(bid(claims(first, 1, {{{0}, -0.5}})));
  hear(bid(claims(third, 1)));
  Update update = tick();
  ASSERT_TRUE(update.decision && update.decision->changed);
  ASSERT_THAT(update.bids, Not(IsEmpty()));
  EXPECT_THAT(update.statuses, IsEmpty()) << "the bid speaks for itself";
  now += 1000;
  EXPECT_THAT(hear(status(first)).statuses, IsEmpty()) << "the third has not answered";
  update = hear(status(third));
  ASSERT_EQ(update.statuses.size(), 1u);
  EXPECT_THAT(update.statuses[0].ready, ElementsAre(self));
}

TEST_F(AgentTest, DoesNotWaitForTheDeadToSpeak) {
  start();
  now = second;
  Statement tombstone = claims(third, 1);
  tombstone.key.dead = true;
  hear(RelayMessage{header(first), tombstone});
  ASSERT_TRUE(tick().decision);
  now += 1000;
  hear(bid(claims(first, 2, {{{1}, -0.5}})));
  EXPECT_TRUE(tick().decision);
}

}  // namespace
}  // namespace arcbid::testing
