// SPDX-License-Identifier: GPL-3.0-or-later
#include "idl/packet_faults.hpp"

#include <gtest/gtest.h>

#include "tests/idl/packets.hpp"

namespace arcbid {
namespace {

using namespace packets;
using Times = std::vector<TimeNs>;

const std::vector<Uav> fleet{
    {{1}, Vec3::Zero(), 1}, {{2}, Vec3::Zero(), 1}, {{3}, Vec3::Zero(), 1}};

constexpr TimeNs launch_ns = 1'000'000;

GuidPrefix prefix_of(std::uint32_t agent) {
  return new_guid_prefix(AgentId{agent}, "127.0.0.1");
}

FaultSchedule on_all_links(LinkFault fault) {
  FaultSchedule schedule;
  schedule.links.push_back(std::move(fault));
  return schedule;
}

FaultSchedule all_cut() {
  LinkFault fault;
  fault.cut = true;
  return on_all_links(fault);
}

TEST(PacketFaults, LetAllPassUntilTheyAreInstalled) {
  PacketFaults faults;
  EXPECT_EQ(faults.arrivals_ns(bid(prefix_of(1)), 7), Times{7});
  EXPECT_TRUE(faults.counters().empty());
  faults.install(all_cut(), fleet, {2}, launch_ns);
  EXPECT_EQ(faults.arrivals_ns(bid(prefix_of(1)), launch_ns), Times{});
  EXPECT_EQ(faults.counters().at({1}).dropped, 1u);
}

TEST(PacketFaults, SpareWhatIsNotBetweenAgents) {
  PacketFaults faults;
  faults.install(all_cut(), fleet, {2}, launch_ns);
  const GuidPrefix coordinator = new_guid_prefix(std::nullopt, "127.0.0.1");
  for (const Bytes& packet : {bid(coordinator), bid(prefix_of(2)), bid(prefix_of(9)),
                              announcement(prefix_of(1)), Bytes{1, 2, 3}})
    EXPECT_EQ(faults.arrivals_ns(packet, launch_ns), Times{launch_ns});
  for (const auto& [sender, link] : faults.counters()) EXPECT_EQ(link.sent, 0u) << sender.value;
}

TEST(PacketFaults, HaveWindowsThatCountFromTheLaunch) {
  LinkFault late;
  late.cut = true;
  late.when = {500, 600};
  PacketFaults faults;
  faults.install(on_all_links(late), fleet, {2}, launch_ns);
  EXPECT_EQ(faults.arrivals_ns(bid(prefix_of(1)), launch_ns + 499), Times{launch_ns + 499});
  EXPECT_EQ(faults.arrivals_ns(bid(prefix_of(1)), launch_ns + 500), Times{});
}

TEST(PacketFaults, DelayAndRepeat) {
  LinkFault slow;
  slow.delay = Delay{Delay::Kind::fixed, 50, 0, 0};
  slow.stale = 1;
  slow.stale_ns = 1000;
  PacketFaults faults;
  faults.install(on_all_links(slow), fleet, {2}, launch_ns);
  EXPECT_EQ(faults.arrivals_ns(bid(prefix_of(1)), launch_ns),
            (Times{launch_ns + 50, launch_ns + 1050}));
}

TEST(PacketFaults, DealWithTheNthPacketAsTheModelDoesWithMessageN) {
  LinkFault lossy;
  lossy.loss = 0.5;
  const FaultSchedule schedule = on_all_links(lossy);
  PacketFaults faults;
  faults.install(schedule, fleet, {2}, launch_ns);
  LinkModel from_1(schedule, fleet, {1}, {2}), from_3(schedule, fleet, {3}, {2});
  const Bytes one = bid(prefix_of(1)), three = bid(prefix_of(3));
  for (std::uint64_t n = 1; n <= 100; ++n) {
    EXPECT_EQ(faults.arrivals_ns(one, launch_ns).size(),
              from_1.send(n, one.size(), 0).arrivals_ns.size());
    // Another life of the same agent is the same link.
    EXPECT_EQ(faults.arrivals_ns(n > 50 ? bid(prefix_of(3)) : three, launch_ns).size(),
              from_3.send(n, three.size(), 0).arrivals_ns.size());
  }
  EXPECT_EQ(faults.counters().at({1}), from_1.counters());
  EXPECT_EQ(faults.counters().at({3}), from_3.counters());
  EXPECT_NE(from_1.counters().dropped, from_3.counters().dropped);
}

}  // namespace
}  // namespace arcbid
