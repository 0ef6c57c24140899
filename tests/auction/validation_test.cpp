// SPDX-License-Identifier: GPL-3.0-or-later
// One test for each reason to refuse; what a reason says must name the value.
#include "core/auction/validation.hpp"

#include <gmock/gmock.h>

#include <limits>

namespace arcbid::testing {
namespace {

using ::testing::HasSubstr;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

class Refusal : public ::testing::Test {
 protected:
  const Expected claims_expected{.mission_digest = 0xabc,
                                 .task_digest = 0xdef,
                                 .tasks = 4,
                                 .self = {2},
                                 .policy = PolicyKind::claims};
  const Expected cbba_expected{.mission_digest = 0xabc,
                               .task_digest = 0xdef,
                               .tasks = 4,
                               .self = {2},
                               .policy = PolicyKind::cbba};
  const View view{{{2}, {3}, {5}}};
  Header header{.sender = {3},
                .incarnation = 9,
                .sequence = 1,
                .mission_digest = 0xabc,
                .task_digest = 0xdef};
  Statement claims{{3}, {9, false, 1}, Claims{{{{3}, -7.5}, {{0}, -9.0}}}};
  Statement table{
      {3}, {9, false, 1}, Table{{{AgentId{5}, 2.0}, {AgentId{2}, -1.0}, {}, {}}, {1, 2, 3}}};
  StatusMessage status{.header = header,
                       .phase = Phase::auction,
                       .ready = {{2}, {5}},
                       .view = {{{2}, {}}, {{3}, {}}, {{5}, {}}},
                       .heartbeats = {{{2}, {}}, {{3}, {}}}};

  void expect_sound(const auto& message) const {
    EXPECT_EQ(refusal_of(message), std::nullopt) << *refusal_of(message);
  }
  void expect_refused(const auto& message, const char* reason) const {
    const auto got = refusal_of(message);
    ASSERT_TRUE(got) << "was not refused; expected: " << reason;
    EXPECT_THAT(*got, HasSubstr(reason));
    EXPECT_EQ(got->find('\n'), std::string::npos);
  }

 private:
  std::optional<std::string> refusal_of(const Header& h) const {
    return refusal(h, claims_expected, view);
  }
  std::optional<std::string> refusal_of(const Statement& s) const {
    const bool is_table = std::holds_alternative<Table>(s.body);
    return refusal(s, is_table ? cbba_expected : claims_expected, view);
  }
  std::optional<std::string> refusal_of(const StatusMessage& s) const { return refusal(s, view); }
};

TEST_F(Refusal, SparesWhatIsSound) {
  expect_sound(header);
  expect_sound(claims);
  expect_sound(table);
  expect_sound(status);
  expect_sound(Statement{{5}, {9, false, 1}, Claims{}});
}

TEST_F(Refusal, OfASenderWhoIsNotOfTheFleet) {
  header.sender = {4};
  expect_refused(header, "agent 4 is not of the fleet");
}

TEST_F(Refusal, OfASecondProcessWithTheSameId) {
  header.sender = {2};
  expect_refused(header, "another process says it is agent 2");
}

TEST_F(Refusal, OfAnotherMission) {
  header.mission_digest = 0xabd;
  expect_refused(header, "mission 0000000000000abd, not 0000000000000abc");
}

TEST_F(Refusal, OfAnotherSplit) {
  header.task_digest = 0xdee;
  expect_refused(header, "0000000000000dee, not 0000000000000def");
}

TEST_F(Refusal, OfASenderWithoutALife) {
  header.incarnation = 0;
  expect_refused(header, "agent 3 has no life");
}

TEST_F(Refusal, OfALifeAfterWhichThereIsNoOther) {
  header.incarnation = last_incarnation;
  expect_sound(header);
  header.incarnation = last_incarnation + 1;
  expect_refused(header, "is beyond");
  claims.key.incarnation = std::numeric_limits<std::uint64_t>::max();
  expect_refused(claims, "life 18446744073709551615 is beyond");
  expect_refused(Statement{{5}, {last_incarnation + 1, true, 0}, Claims{}}, "is beyond");
  status.view[1].key.incarnation = last_incarnation + 1;
  expect_refused(status, "is beyond");
}

TEST_F(Refusal, OfAnOwnLifeThatLeavesNoneToAnswerWith) {
  expect_sound(Statement{{2}, {last_incarnation - 1, true, 0}, Claims{}});
  expect_refused(Statement{{2}, {last_incarnation, true, 0}, Claims{}}, "is beyond");
  expect_sound(Statement{{3}, {last_incarnation, true, 0}, Claims{}});
}

TEST_F(Refusal, OfAHeartbeatOfALifeAfterWhichThereIsNoOther) {
  // Passed on, it would make all deaf to the member's own heartbeats.
  status.heartbeats[1].heartbeat.incarnation = last_incarnation + 1;
  expect_refused(status, "is beyond");
}

TEST_F(Refusal, OfWhatAnotherPolicyStates) {
  EXPECT_THAT(refusal(table, claims_expected, view).value_or(""), HasSubstr("policy is claims"));
  EXPECT_THAT(refusal(claims, cbba_expected, view).value_or(""), HasSubstr("policy is cbba"));
  const Statement tombstone{{5}, {9, true, 1}, Claims{}};
  EXPECT_EQ(refusal(tombstone, cbba_expected, view), std::nullopt) << "the same under both";
}

TEST_F(Refusal, OfAStatementOfAStranger) {
  claims.agent = {77};
  expect_refused(claims, "agent 77");
}

TEST_F(Refusal, OfAStatementWithoutALife) {
  claims.key.incarnation = 0;
  expect_refused(claims, "without a life");
}

TEST_F(Refusal, OfATaskOutOfRange) {
  claims.body = Claims{{{{4}, -1.0}}};
  expect_refused(claims, "task 4 is outside [0, 4)");
  claims.body = Claims{{{{4'000'000'000}, -1.0}}};
  expect_refused(claims, "task 4000000000");
}

TEST_F(Refusal, OfABidThatIsNoNumber) {
  for (const double bid : {nan, infinite, -infinite}) {
    claims.body = Claims{{{{1}, -1.0}, {{2}, bid}}};
    expect_refused(claims, "the bid for task 2 is");
  }
}

TEST_F(Refusal, OfATaskClaimedTwice) {
  claims.body = Claims{{{{1}, -1.0}, {{2}, -2.0}, {{1}, -3.0}}};
  expect_refused(claims, "task 1 is claimed twice");
}

TEST_F(Refusal, OfMoreTasksThanTheLimit) {
  Expected expected = claims_expected;
  expected.bundle_limit = 2;
  EXPECT_EQ(refusal(claims, expected, view), std::nullopt);
  expected.bundle_limit = 1;
  EXPECT_THAT(refusal(claims, expected, view).value_or(""),
              HasSubstr("agent 3 takes 2 tasks, more than 1"));
  expected = cbba_expected;
  expected.bundle_limit = 1;
  EXPECT_EQ(refusal(table, expected, view), std::nullopt) << "the tasks are others'";
  for (Belief& belief : std::get<Table>(table.body).beliefs) belief = {AgentId{3}, 1};
  EXPECT_THAT(refusal(table, expected, view).value_or(""),
              HasSubstr("agent 3 takes 4 tasks, more than 1"));
}

TEST_F(Refusal, OfATombstoneThatClaimsTasks) {
  claims.key.dead = true;
  expect_refused(claims, "a tombstone that claims tasks");
  table.key.dead = true;
  expect_refused(table, "a tombstone that claims tasks");
}

TEST_F(Refusal, SparesATombstoneOfSomebodyWhoNeverLived) {
  expect_sound(Statement{{5}, {0, true, 0}, Claims{}});
}

TEST_F(Refusal, OfATableOfTheWrongSize) {
  std::get<Table>(table.body).beliefs.pop_back();
  expect_refused(table, "a table of 3 tasks, not 4");
}

TEST_F(Refusal, OfTheWrongNumberOfTimestamps) {
  std::get<Table>(table.body).timestamps.push_back(1);
  expect_refused(table, "4 timestamps, not 3");
}

TEST_F(Refusal, OfATableWithABidThatIsNoNumber) {
  std::get<Table>(table.body).beliefs[3].bid = nan;
  expect_refused(table, "the bid for task 3 is nan");
}

TEST_F(Refusal, OfATableWithAWinnerWhoIsNotOfTheFleet) {
  std::get<Table>(table.body).beliefs[2].winner = AgentId{4};
  expect_refused(table, "task 2 is won by agent 4");
}

TEST_F(Refusal, OfAStatusWithAViewOfTheWrongSize) {
  status.view.pop_back();
  expect_refused(status, "a whole view of 2");
  status.whole = false;
  expect_sound(status);
}

TEST_F(Refusal, OfAStatusThatSpeaksOfStrangersOrOfOneTwice) {
  status.heartbeats.push_back({{4}, {}});
  expect_refused(status, "it speaks of agent 4, who is not of the fleet");
  status.heartbeats.back().agent = {3};
  expect_refused(status, "it speaks of agent 3 after agent 3");
  status.heartbeats.pop_back();
  std::swap(status.view[0], status.view[1]);
  expect_refused(status, "it speaks of agent 2 after agent 3");
}

TEST_F(Refusal, OfAStatusThatCallsAStrangerReady) {
  status.ready.push_back({4});
  expect_refused(status, "agent 4 is called ready");
}

}  // namespace
}  // namespace arcbid::testing
