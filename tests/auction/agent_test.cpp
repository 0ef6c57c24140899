// SPDX-License-Identifier: GPL-3.0-or-later
// One agent: silence and return, agreement, and what it sends.
#include <gmock/gmock.h>

#include "tests/auction/agent_fixture.hpp"

namespace arcbid::testing {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Not;

// -- silence and return

TEST_F(AgentTest, BuriesTheSilentAfterTheLease) {
  start();
  const Update update = tick_until([](const Update& u) { return !u.died.empty(); });
  EXPECT_THAT(update.died, ElementsAre(first, third));
  EXPECT_EQ(now, mission->auction.lease_ns + 1);
  EXPECT_TRUE(agent->view().dead(first));
}

TEST_F(AgentTest, CountsARelayedHeartbeatAsLife) {
  start();
  now = second;
  StatusMessage message = status(first);
  message.heartbeats[at_third].heartbeat = {life(third), 50};
  hear(message);
  now = second + mission->auction.lease_ns;
  EXPECT_THAT(tick().died, IsEmpty());
  now += 1;
  EXPECT_THAT(tick().died, ElementsAre(first, third));
}

TEST_F(AgentTest, BuriesNobodyBeforeAllThatWaitsWasHeard) {
  start();
  now = 3 * mission->auction.lease_ns;  // it was held up itself; heartbeats queue
  EXPECT_THAT(hear(status(first)).died, IsEmpty());
  EXPECT_EQ(wake_ns, now) << "a tick is due";
  EXPECT_THAT(hear(status(third)).died, IsEmpty());
  EXPECT_THAT(tick().died, IsEmpty());
}

TEST_F(AgentTest, TakesOverFromTheDeadAndGivesBackToTheReturned) {
  start();
  std::vector<Claim> everything;
  for (const Task& task : agent->tasks().tasks) everything.push_back({task.id, 1000.0});
  hear(bid(claims(first, 1, everything)));
  settle();
  for (const Belief& belief : agent->winners()) ASSERT_EQ(belief.winner, first);

  Statement tombstone{first, {life(first), true, 1}, Claims{}};
  EXPECT_THAT(hear(RelayMessage{header(third), tombstone}).died, ElementsAre(first));
  settle();
  for (const Belief& belief : agent->winners()) EXPECT_EQ(belief.winner, self);

  Statement reborn{first, {life(first) + 1, false, 1}, Claims{everything}};
  EXPECT_THAT(hear(bid(reborn)).returned, ElementsAre(first));
  settle();
  for (const Belief& belief : agent->winners()) EXPECT_EQ(belief.winner, first);
}

TEST_F(AgentTest, AnswersATombstoneOfItselfWithANewLife) {
  start();
  settle();
  const Statement tombstone{self, {own_life, true, 1}, Claims{}};
  const Update update = hear(RelayMessage{header(third), tombstone});
  EXPECT_EQ(update.refused, std::nullopt);
  ASSERT_EQ(update.bids.size(), 1u);
  EXPECT_EQ(update.bids[0].statement.key, (StatementKey{own_life + 1, false, 1}));
  EXPECT_EQ(update.bids[0].header.incarnation, own_life + 1);
  EXPECT_FALSE(agent->view().dead(self));
  EXPECT_THAT(update.died, IsEmpty());
}

TEST_F(AgentTest, AnswersATombstoneThatItOnlySeesInAStatus) {
  start();
  settle();
  StatusMessage message = status(third);
  message.view[at_self].key = {own_life + 40, true, 3};
  const Update update = hear(message);
  ASSERT_EQ(update.bids.size(), 1u);
  EXPECT_EQ(update.bids[0].statement.key, (StatementKey{own_life + 41, false, 1}));
}

TEST_F(AgentTest, AnswersWhatItNeverSaidInThisLife) {
  start();
  settle();
  hear(RelayMessage{header(third), {self, {own_life, false, 900}, Claims{}}});
  EXPECT_EQ(agent->view().key(at_self), (StatementKey{own_life + 1, false, 1}));
}

TEST_F(AgentTest, AnswersAHeartbeatOfALifeThatItDoesNotLead) {
  // Left alone it would make all deaf to this agent's own heartbeats.
  start();
  settle();
  StatusMessage message = status(third);
  message.heartbeats[at_self].heartbeat = {own_life + 5, 1};
  hear(message);
  EXPECT_EQ(agent->view().key(at_self), (StatementKey{own_life + 6, false, 1}));
}

TEST_F(AgentTest, StartsAboveAnOldLifeThatItHearsOfBeforeTheStart) {
  hear(RelayMessage{header(third), {self, {own_life + 7, false, 9}, Claims{}}});
  start();
  settle();
  EXPECT_EQ(agent->view().key(at_self).incarnation, own_life + 8);
}

// -- agreement

TEST_F(AgentTest, AgreesOnceEverybodyIsKnownToHaveBeenReady) {
  const Update update = agree();
  ASSERT_TRUE(update.agreed);
  EXPECT_EQ(agent->phase(), Phase::agreed);
  EXPECT_EQ(update.agreed->view_hash, agent->view().hash());
  EXPECT_THAT(update.agreed->members, ElementsAre(first, self, third));
  EXPECT_EQ(update.agreed->winners, agent->winners());
  EXPECT_EQ(update.agreed->path.size(), agent->tasks().tasks.size());
}

TEST_F(AgentTest, DoesNotAgreeWhileSomebodyIsNotKnownToBeReady) {
  start();
  hear(bid(claims(first, 1)));
  hear(bid(claims(third, 1)));
  settle();
  StatusMessage message = status(first);
  message.view_hash = agent->view().hash();
  message.ready = {first};
  EXPECT_FALSE(hear(message).agreed);
  message = status(third);
  message.view_hash = agent->view().hash() + 1;
  message.ready = {first, third};
  EXPECT_FALSE(hear(message).agreed) << "ready for something else";
}

TEST_F(AgentTest, LosesItsAgreementWhenSomethingOutsideChanges) {
  ASSERT_TRUE(agree().agreed);
  const Update update = hear(bid(claims(third, 2)));
  EXPECT_TRUE(update.agreement_lost);
  EXPECT_EQ(agent->phase(), Phase::auction);
  EXPECT_FALSE(hear(bid(claims(third, 3))).agreement_lost) << "there was none any more";
}

TEST_F(AgentTest, KeepsItsAgreementWhenItHearsNothingNew) {
  ASSERT_TRUE(agree().agreed);
  EXPECT_FALSE(hear(bid(claims(third, 1))).agreement_lost);
  EXPECT_FALSE(hear(status(third)).agreement_lost);
  EXPECT_EQ(agent->phase(), Phase::agreed);
}

TEST_F(AgentTest, IsRoutedOnceTheRouteOfThisAgreementIsPublished) {
  const Update update = agree();
  ASSERT_TRUE(update.agreed);
  hear(RoutePublished{update.agreed->view_hash + 1});
  EXPECT_EQ(agent->phase(), Phase::agreed) << "the route of another agreement";
  hear(RoutePublished{update.agreed->view_hash});
  EXPECT_EQ(agent->phase(), Phase::routed);
  EXPECT_TRUE(hear(bid(claims(third, 2))).agreement_lost);
}

TEST_F(AgentTest, IsNotRoutedByALateRoute) {
  const std::uint64_t old = agree().agreed->view_hash;
  hear(bid(claims(third, 2)));
  hear(RoutePublished{old});
  EXPECT_EQ(agent->phase(), Phase::auction);
}

TEST_F(AgentTest, PassesReadinessOnWithinATick) {
  start();
  hear(bid(claims(first, 1)));
  hear(bid(claims(third, 1)));
  settle();
  StatusMessage message = status(third);
  message.view_hash = agent->view().hash();
  message.ready = {third};
  Update update = hear(message);
  if (update.statuses.empty()) {
    EXPECT_LE(wake_ns, now + mission->auction.tick_ns);
    now = wake_ns;
    update = tick();
  }
  ASSERT_EQ(update.statuses.size(), 1u);
  EXPECT_EQ(update.statuses[0].view_hash, agent->view().hash());
  EXPECT_THAT(update.statuses[0].ready, ElementsAre(self, third));
}

// -- what it sends

TEST_F(AgentTest, SendsItsHeartbeatAndThoseItHeardOf) {
  start();
  StatusMessage heard = status(first);
  heard.heartbeats[at_third].heartbeat = {life(third), 77};
  hear(heard);
  now = second / 4;
  const Update update = tick();
  ASSERT_EQ(update.statuses.size(), 1u);
  const StatusMessage& sent = update.statuses[0];
  EXPECT_TRUE(sent.whole);
  EXPECT_THAT(sent.heartbeats, ElementsAre(Pulse{first, {life(first), heard.header.sequence}},
                                           Pulse{third, {life(third), 77}}))
      << "its own heartbeat is the header";
  EXPECT_THAT(sent.view, ElementsAre(Held{first, agent->view().key(at_first)},
                                     Held{self, agent->view().key(at_self)},
                                     Held{third, agent->view().key(at_third)}));
}

TEST_F(AgentTest, SaysOnlyWhatIsNewBetweenWholeStatuses) {
  start();
  settle();
  const auto next_status = [&](bool whole) {
    const Update update = tick_until(
        [&](const Update& u) { return !u.statuses.empty() && u.statuses[0].whole == whole; });
    return update.statuses.at(0);
  };
  EXPECT_EQ(next_status(true).view.size(), 3u);
  hear(bid(claims(first, 2)));
  const StatusMessage partial = next_status(false);
  EXPECT_THAT(partial.view, Contains(Held{first, {life(first), false, 2}}));
  EXPECT_THAT(partial.view, Not(Contains(::testing::Field(&Held::agent, third))));
  EXPECT_THAT(partial.heartbeats, IsEmpty()) << "nobody began a new life";
  hear(bid(claims(third, 2)));
  const StatusMessage later = next_status(false);
  EXPECT_THAT(later.view, Contains(Held{first, {life(first), false, 2}}))
      << "the last status may be lost: what is new is said until the next whole one";
  EXPECT_THAT(later.view, Contains(Held{third, {life(third), false, 2}}));
}

TEST_F(AgentTest, SaysAtOnceThatAMemberBeganANewLife) {
  start();
  settle();
  StatusMessage heard = status(first);
  heard.heartbeats[at_third].heartbeat = {life(third) + 9, 1};
  hear(heard);
  hear(bid(claims(first, 2)));
  const Update update = tick_until([](const Update& u) { return !u.statuses.empty(); });
  EXPECT_THAT(update.statuses[0].heartbeats, Contains(Pulse{third, {life(third) + 9, 1}}));
}

TEST_F(AgentTest, RepeatsItsBidToWhoeverLacksIt) {
  start();
  settle();
  StatusMessage message = status(third);
  message.view[at_self].key = {};
  ASSERT_THAT(hear(message).bids, IsEmpty());
  const Update update = tick_until([](const Update& u) { return !u.bids.empty(); });
  ASSERT_EQ(update.bids.size(), 1u);
  EXPECT_EQ(update.bids[0].statement.key, agent->view().key(at_self));
}

TEST_F(AgentTest, RelaysWhatAPeerLacksAfterSomePatience) {
  start();
  hear(bid(claims(first, 1)));
  settle();
  StatusMessage message = status(third);
  message.view[at_first].key = {};
  ASSERT_THAT(hear(message).relays, IsEmpty());
  const Update update = tick_until([](const Update& u) { return !u.relays.empty(); });
  ASSERT_EQ(update.relays.size(), 1u);
  EXPECT_EQ(update.relays[0].header.sender, self);
  EXPECT_EQ(update.relays[0].statement.agent, first);
  EXPECT_EQ(update.relays[0].statement.key, agent->view().key(at_first));
}

class CbbaAgentTest : public AgentTest {
 protected:
  CbbaAgentTest() : AgentTest(PolicyKind::cbba) {}
};

TEST_F(CbbaAgentTest, IsNotReadyWhileItsDecisionIsUnsettled) {
  tick();
  now = second / 10;
  hear(status(first, Phase::waiting_for_peers));
  now = second / 5;
  hear(status(third, Phase::waiting_for_peers));
  now += 1'000'000;
  const Update update = tick();
  ASSERT_TRUE(update.decision);
  ASSERT_TRUE(update.decision->changed) << "its first bids";
  EXPECT_THAT(update.statuses, IsEmpty()) << "the bid speaks for itself";
  now = wake_ns;
  const Update between = tick();
  ASSERT_FALSE(between.decision);
  ASSERT_EQ(between.statuses.size(), 1u);
  EXPECT_THAT(between.statuses[0].ready, IsEmpty());
  now = wake_ns;
  const Update later = tick();
  ASSERT_EQ(later.statuses.size(), 1u);
  EXPECT_THAT(later.statuses[0].ready, ElementsAre(self));
}

TEST_F(CbbaAgentTest, DoesNotAgreeWhenAllAreReadyButBelieveDifferently) {
  start();
  const Table nobody{std::vector<Belief>(agent->tasks().tasks.size()), {0, 0, 0}};
  Table same = nobody;
  for (const AgentId peer : {first, third}) hear(bid({peer, {life(peer), false, 1}, nobody}));
  settle();
  same.beliefs = agent->winners();
  const auto all_ready = [&] {
    StatusMessage message = status(third);
    message.view_hash = agent->view().hash();
    message.ready = {first, third};
    return hear(message);
  };
  EXPECT_FALSE(all_ready().agreed);
  for (const AgentId peer : {first, third}) hear(bid({peer, {life(peer), false, 2}, same}));
  settle();
  EXPECT_TRUE(all_ready().agreed);
}

}  // namespace
}  // namespace arcbid::testing
