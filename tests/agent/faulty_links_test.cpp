// SPDX-License-Identifier: GPL-3.0-or-later
#include "agent/faulty_links.hpp"

#include <gtest/gtest.h>

namespace arcbid::testing {
namespace {

const std::vector<Uav> fleet{
    {{1}, Vec3::Zero(), 1}, {{2}, Vec3::Zero(), 1}, {{3}, Vec3::Zero(), 1}};

BidMessage bid(std::uint32_t sender, std::uint64_t sequence) {
  BidMessage message;
  message.header.sender = {sender};
  message.header.sequence = sequence;
  return message;
}

std::vector<std::uint64_t> numbers(const std::vector<AgentMessage>& messages) {
  std::vector<std::uint64_t> out;
  for (const AgentMessage& message : messages)
    out.push_back(std::get<BidMessage>(message).header.sequence);
  return out;
}

FaultSchedule with(LinkFault fault) {
  FaultSchedule schedule;
  schedule.links.push_back(std::move(fault));
  return schedule;
}

TEST(FaultyLinks, LetThroughWhatNothingIsDoneTo) {
  FaultyLinks links(FaultSchedule{}, fleet, {2});
  links.arrived(bid(1, 7), 100, 50);
  EXPECT_EQ(links.next_ns(), 50);
  EXPECT_EQ(numbers(links.due(50)), (std::vector<std::uint64_t>{7}));
  EXPECT_EQ(links.next_ns(), std::nullopt);
  EXPECT_EQ(links.counters().at({1}).sent, 1u);
  EXPECT_EQ(links.counters().at({3}).sent, 0u);
}

TEST(FaultyLinks, HoldBackWhatIsDelayedAndInOrderOfItsDueTime) {
  LinkFault slow;
  slow.from = {{1}};
  slow.delay = Delay{Delay::Kind::fixed, 1000, 0, 0};
  FaultyLinks links(with(slow), fleet, {2});
  EXPECT_EQ(links.arrived(bid(1, 1), 100, 0), (std::vector<TimeNs>{1000}));
  EXPECT_EQ(links.arrived(bid(3, 2), 100, 500), (std::vector<TimeNs>{500}));
  EXPECT_EQ(numbers(links.due(999)), (std::vector<std::uint64_t>{2}));
  EXPECT_EQ(links.next_ns(), 1000);
  EXPECT_EQ(numbers(links.due(1000)), (std::vector<std::uint64_t>{1}));
  EXPECT_EQ(links.counters().at({1}).delayed, 1u);
}

TEST(FaultyLinks, DropAndDoubleByLink) {
  LinkFault cut, twice;
  cut.from = {{1}};
  cut.cut = true;
  twice.from = {{3}};
  twice.duplicate = 1;
  FaultSchedule schedule = with(cut);
  schedule.links.push_back(twice);
  FaultyLinks links(schedule, fleet, {2});
  EXPECT_EQ(links.arrived(bid(1, 1), 100, 0).size(), 0u);
  EXPECT_EQ(links.arrived(bid(3, 2), 100, 0).size(), 2u);
  EXPECT_EQ(numbers(links.due(1'000'000'000)), (std::vector<std::uint64_t>{2, 2}));
  EXPECT_EQ(links.counters().at({1}).dropped, 1u);
  EXPECT_EQ(links.counters().at({3}).duplicated, 1u);
}

TEST(FaultyLinks, PassStrangersOnToWhoeverRefusesThem) {
  LinkFault all_cut;
  all_cut.cut = true;
  FaultyLinks links(with(all_cut), fleet, {2});
  links.arrived(bid(9, 5), 100, 0);
  EXPECT_EQ(numbers(links.due(0)), (std::vector<std::uint64_t>{5}));
}

}  // namespace
}  // namespace arcbid::testing
