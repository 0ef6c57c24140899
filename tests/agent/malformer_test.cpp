// SPDX-License-Identifier: GPL-3.0-or-later
#include "agent/malformer.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace arcbid::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr TimeNs tick = 20;
constexpr std::size_t tasks = 3;
constexpr AgentId self{2};

AgentFault fault(Malformation how, TimeNs at_ns, std::uint32_t count, AgentId agent = self) {
  AgentFault out;
  out.agent = agent;
  out.kind = AgentFaultKind::malformed;
  out.at_ns = at_ns;
  out.malformation = how;
  out.count = count;
  return out;
}

Malformer under(std::vector<AgentFault> faults) {
  FaultSchedule schedule;
  schedule.agents = std::move(faults);
  return Malformer(schedule, self, tasks, tick);
}

BidMessage bid(std::uint32_t version) {
  return {{self, 100, version, 7, 8}, {self, {100, false, version}, Claims{{{{1}, -5}}}}};
}

std::vector<Malformation> kinds(const Malformer::Speech& speech) {
  std::vector<Malformation> out;
  for (const auto& said : speech.messages) out.push_back(said.how);
  return out;
}

TEST(Malformer, SaysNothingBeforeItsTimeNorBeforeThereIsSomethingToSpoil) {
  Malformer early = under({fault(Malformation::nan_bid, 100, 1)});
  EXPECT_THAT(early.due(500).messages, IsEmpty());
  EXPECT_EQ(early.next_ns(), std::nullopt);
  early.said(bid(1));
  EXPECT_EQ(early.next_ns(), 100);
  EXPECT_THAT(early.due(99).messages, IsEmpty());
  EXPECT_THAT(kinds(early.due(100)), ElementsAre(Malformation::nan_bid));
}

TEST(Malformer, LeavesTheFaultsOfOthersToThem) {
  Malformer other = under({fault(Malformation::nan_bid, 0, 1, {3})});
  other.said(bid(1));
  EXPECT_THAT(other.due(1000).messages, IsEmpty());
}

TEST(Malformer, SaysOneOfEachATickUntilItsCount) {
  Malformer two =
      under({fault(Malformation::wrong_mission, 0, 2), fault(Malformation::wrong_tasks, 10, 1)});
  two.said(bid(1));
  EXPECT_THAT(kinds(two.due(0)), ElementsAre(Malformation::wrong_mission));
  EXPECT_EQ(two.next_ns(), 10);
  EXPECT_THAT(kinds(two.due(10)), ElementsAre(Malformation::wrong_tasks));
  EXPECT_THAT(two.due(tick - 1).messages, IsEmpty());
  EXPECT_THAT(kinds(two.due(tick)), ElementsAre(Malformation::wrong_mission));
  EXPECT_EQ(two.next_ns(), std::nullopt);
  EXPECT_THAT(two.due(1000).messages, IsEmpty());
}

TEST(Malformer, SpoilsWhatWasSaidLast) {
  Malformer one = under({fault(Malformation::nan_bid, 0, 1)});
  one.said(bid(1));
  one.said(bid(2));
  const auto speech = one.due(0);
  ASSERT_EQ(speech.messages.size(), 1u);
  const BidMessage& bad = speech.messages[0].message;
  EXPECT_GT(bad.statement.key, bid(2).statement.key) << "else it would be left alone as old news";
  const auto& bundle = std::get<Claims>(bad.statement.body).bundle;
  ASSERT_EQ(bundle.size(), 2u);
  EXPECT_TRUE(std::isnan(bundle[1].bid));
  EXPECT_FALSE(speech.ends);
}

TEST(Malformer, ReplaysOldMessagesAsTheyWere) {
  Malformer replay = under({fault(Malformation::replay, 0, 2)});
  replay.said(bid(1));
  replay.said(bid(2));
  std::vector<std::uint32_t> versions;
  for (const TimeNs now : {TimeNs{0}, tick})
    for (const auto& said : replay.due(now).messages)
      versions.push_back(said.message.statement.key.version);
  EXPECT_THAT(versions, ElementsAre(1, 2));
}

TEST(Malformer, BidsOverAllTasksAndThenItsProcessEnds) {
  Malformer over = under({fault(Malformation::over_bid, 50, 3)});
  over.said(bid(1));
  EXPECT_FALSE(over.due(49).ends);
  const auto speech = over.due(50);
  EXPECT_TRUE(speech.ends);
  ASSERT_EQ(speech.messages.size(), 3u);
  std::uint64_t sequence = 1;
  for (const auto& said : speech.messages) {
    EXPECT_EQ(said.message.header.sequence, ++sequence);
    const auto& bundle = std::get<Claims>(said.message.statement.body).bundle;
    ASSERT_EQ(bundle.size(), tasks);
    for (const Claim& claim : bundle) EXPECT_GT(claim.bid, 1e6);
  }
}

}  // namespace
}  // namespace arcbid::testing
