// SPDX-License-Identifier: GPL-3.0-or-later
// What an agent refuses, and that nothing of it is applied.
#include <gmock/gmock.h>

#include <limits>

#include "tests/auction/agent_fixture.hpp"

namespace arcbid::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

class MisbehavingPeer : public AgentTest {
 protected:
  void SetUp() override {
    start();
    hear(bid(claims(first, 1, {{{0}, -1.0}})));
    hear(bid(claims(third, 1)));
    settle();
  }
  void expect_refused(const auto& message, const char* reason) {
    const auto hash = agent->view().hash();
    const auto keys = agent->view().keys();
    const auto winners = agent->winners();
    const Update update = hear(message);
    ASSERT_TRUE(update.refused) << "was not refused; expected: " << reason;
    EXPECT_THAT(*update.refused, HasSubstr(reason));
    EXPECT_FALSE(update.decision);
    EXPECT_THAT(update.died, IsEmpty());
    EXPECT_EQ(agent->view().hash(), hash);
    EXPECT_EQ(agent->view().keys(), keys);
    EXPECT_EQ(agent->winners(), winners);
    settle();
    EXPECT_EQ(agent->winners(), winners);
    EXPECT_EQ(hear(bid(claims(first, 2))).refused, std::nullopt) << "the next one is sound";
    settle();
  }
};

TEST_F(MisbehavingPeer, BidsNaN) {
  expect_refused(bid(claims(first, 2, {{{0}, std::numeric_limits<double>::quiet_NaN()}})),
                 "task 0 is nan");
}

TEST_F(MisbehavingPeer, BidsInfinity) {
  expect_refused(bid(claims(first, 2, {{{0}, std::numeric_limits<double>::infinity()}})),
                 "task 0 is inf");
}

TEST_F(MisbehavingPeer, ClaimsATaskThatDoesNotExist) {
  expect_refused(bid(claims(first, 2, {{{1'000'000}, -1.0}})), "task 1000000 is outside");
}

TEST_F(MisbehavingPeer, ClaimsATaskTwice) {
  expect_refused(bid(claims(first, 2, {{{0}, -1.0}, {{0}, -2.0}})), "claimed twice");
}

TEST_F(MisbehavingPeer, IsAStranger) {
  expect_refused(BidMessage{header({9}), claims({9}, 1)}, "agent 9 is not of the fleet");
}

TEST_F(MisbehavingPeer, RelaysAStranger) {
  expect_refused(RelayMessage{header(first), claims({9}, 1)}, "agent 9");
}

TEST_F(MisbehavingPeer, FliesAnotherMission) {
  BidMessage message = bid(claims(first, 2));
  message.header.mission_digest ^= 1;
  expect_refused(message, "flies mission");
}

TEST_F(MisbehavingPeer, SplitsTheArcsDifferently) {
  BidMessage message = bid(claims(first, 2));
  message.header.task_digest ^= 1;
  expect_refused(message, "split the arcs differently");
  StatusMessage report = status(third);
  report.header.task_digest ^= 1;
  EXPECT_TRUE(hear(report).refused);
}

TEST_F(MisbehavingPeer, BidsInAnothersName) {
  expect_refused(BidMessage{header(first), claims(third, 2)}, "in another agent's name");
}

TEST_F(MisbehavingPeer, TakesThisAgentsId) {
  expect_refused(BidMessage{header(self), {self, {9999, false, 1}, Claims{}}}, "another process");
  expect_refused(status(self), "another process");
}

TEST_F(MisbehavingPeer, ReportsAViewOfTheWrongSize) {
  StatusMessage message = status(first);
  message.view.resize(2);
  expect_refused(message, "a whole view of 2");
  message = status(first);
  message.view.clear();
  EXPECT_TRUE(hear(message).refused);
}

TEST_F(MisbehavingPeer, ReportsHeartbeatsOfStrangersOrTwice) {
  StatusMessage message = status(first);
  message.heartbeats.push_back({{4}, {1, 1}});
  expect_refused(message, "agent 4, who is not of the fleet");
  message = status(first);
  message.heartbeats.push_back({third, {1, 1}});
  expect_refused(message, "agent 3 after agent 3");
}

TEST_F(MisbehavingPeer, ReportsAStrangerReady) {
  StatusMessage message = status(first);
  message.ready = {{9}};
  expect_refused(message, "agent 9 is called ready");
}

TEST_F(MisbehavingPeer, BuriesSomebodyWithClaims) {
  Statement tombstone = claims(third, 1, {{{0}, -1.0}});
  tombstone.key.dead = true;
  expect_refused(RelayMessage{header(first), tombstone}, "a tombstone that claims tasks");
}

TEST_F(MisbehavingPeer, StatesATableUnderTheClaimsPolicy) {
  Table table{std::vector<Belief>(agent->tasks().tasks.size()), std::vector<std::uint64_t>(3)};
  expect_refused(bid({first, {life(first), false, 2}, table}), "policy is claims");
}

TEST_F(MisbehavingPeer, UsesUpTheLivesOfThisAgent) {
  // Refused or answered: otherwise whoever believes the tombstone can never be told better.
  const StatementKey last{std::numeric_limits<std::uint64_t>::max(), true, 0};
  const Update update = hear(RelayMessage{header(first), {self, last, Claims{}}});
  EXPECT_TRUE(update.refused || agent->view().key(at_self) > last);
  StatusMessage message = status(third);
  message.view[at_self].key = last;
  EXPECT_TRUE(hear(message).refused || agent->view().key(at_self) > last);
}

/// A peer under audit, and what it may truly bid.
class OverBidder : public AgentTest {
 protected:
  OverBidder() : AgentTest(PolicyKind::claims, true) {}
  void SetUp() override {
    start();
    settle();
  }
  double true_bid(std::uint32_t task) const {
    const StraightTransit transit;
    return make_score(agent->tasks(), mission->fleet[at_first], mission->auction, transit)
        ->best({task})
        .gain;
  }
  void expect_refused(const auto& message) {
    const auto hash = agent->view().hash();
    const auto winners = agent->winners();
    const Update update = hear(message);
    ASSERT_TRUE(update.refused);
    EXPECT_THAT(*update.refused, HasSubstr("agent 1 bids 1000000000 for task 0, where its path"));
    settle();
    EXPECT_EQ(agent->view().hash(), hash);
    EXPECT_EQ(agent->winners(), winners);
  }
};

TEST_F(OverBidder, IsNotBelieved) {
  expect_refused(bid(claims(first, 1, {{{0}, 1e9}})));
  EXPECT_EQ(hear(bid(claims(first, 2, {{{0}, true_bid(0)}}))).refused, std::nullopt);
  EXPECT_EQ(agent->view().key(at_first).version, 2u);
}

TEST_F(OverBidder, IsNotBelievedByWayOfARelay) {
  expect_refused(RelayMessage{header(third), claims(first, 1, {{{0}, 1e9}})});
}

TEST_F(OverBidder, SayingWhatIsOldIsPassedOver) {
  ASSERT_EQ(hear(bid(claims(first, 3, {{{0}, true_bid(0)}}))).refused, std::nullopt);
  const auto hash = agent->view().hash();
  hear(bid(claims(first, 3, {{{0}, 1e9}})));
  hear(bid(claims(first, 2, {{{0}, 1e9}})));
  EXPECT_EQ(agent->view().hash(), hash);
}

class MisbehavingCbbaPeer : public AgentTest {
 protected:
  MisbehavingCbbaPeer() : AgentTest(PolicyKind::cbba) {}
};

TEST_F(MisbehavingCbbaPeer, StatesClaims) {
  start();
  settle();
  EXPECT_TRUE(hear(bid(claims(first, 1))).refused);
}

TEST_F(MisbehavingCbbaPeer, CreditsAStranger) {
  start();
  settle();
  const auto winners = agent->winners();
  Table table{std::vector<Belief>(winners.size()), std::vector<std::uint64_t>(3)};
  table.beliefs[0] = {AgentId{9}, 1000.0};
  EXPECT_TRUE(hear(bid({first, {life(first), false, 1}, table})).refused);
  settle();
  EXPECT_EQ(agent->winners(), winners);
}

}  // namespace
}  // namespace arcbid::testing
