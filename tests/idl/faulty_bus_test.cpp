// SPDX-License-Identifier: GPL-3.0-or-later
// Packet faults under real Fast DDS.
#include "core/io/process/process.hpp"
#include "tests/idl/bus_fixture.hpp"
#include "tests/idl/samples.hpp"

namespace arcbid {
namespace {

class FaultyBusTest : public BusTest {
 protected:
  std::unique_ptr<Bus> agent(std::uint32_t id) { return BusTest::agent(id, FaultTier::packets); }

  void install(Bus& bus, LinkFault fault) {
    FaultSchedule schedule;
    fault.from = {{1}};
    fault.to = {{2}};
    schedule.links.push_back(std::move(fault));
    bus.set_packet_faults(schedule, fleet_, launch_ns_);
  }

  /// How many of `count` bids by `sender` come out of `to`. No faster than any machine's sockets
  /// take them.
  static std::uint32_t delivered(Bus& from, std::uint32_t sender, Bus& to, std::uint32_t count) {
    std::uint32_t heard = 0;
    const auto hear = [&](std::chrono::nanoseconds limit) {
      bool any = false;
      for (const Received& received : to.wait(limit))
        if (const auto* got = std::get_if<BidMessage>(&received))
          if (got->header.sender == AgentId{sender}) any = ++heard > 0;
      return any;
    };
    for (std::uint32_t version = 1; version <= count; ++version) {
      from.publish(samples::bids(sender, version));
      if (version % 8 == 0) hear(2ms);
    }
    while (hear(500ms)) {
    }
    return heard;
  }

  const std::vector<Uav> fleet_{{{1}, Vec3::Zero(), 1}, {{2}, {5, 0, 0}, 1}};
  const TimeNs launch_ns_ = monotonic_ns();
};

TEST_F(FaultyBusTest, LosesTheShareThatTheScheduleSaysInThatDirectionOnly) {
  const auto one = agent(1), two = agent(2);
  LinkFault lossy;
  lossy.loss = 0.3;
  install(*one, lossy);
  install(*two, lossy);
  ASSERT_TRUE(matched(*one, 1) && matched(*two, 1));
  const double share = delivered(*one, 1, *two, 1200) / 1200.0;
  EXPECT_GT(share, 0.55);
  EXPECT_LT(share, 0.85);
  EXPECT_GT(delivered(*two, 2, *one, 1200), 1080u);  // but for what the kernel may lose

  const LinkCounters there = two->packet_counters().at({1}), back = one->packet_counters().at({2});
  EXPECT_GE(there.sent, 1080u);
  EXPECT_GT(there.dropped, there.sent / 5);
  EXPECT_GE(back.sent, 1080u);
  EXPECT_EQ(back.dropped, 0u);
}

TEST_F(FaultyBusTest, CutsALinkWithoutHidingThePeer) {
  const auto boss = coordinator(), one = agent(1), two = agent(2);
  LinkFault cut;
  cut.cut = true;
  install(*one, cut);
  install(*two, cut);
  ASSERT_TRUE(matched(*one, 1) && matched(*two, 1) && matched(*boss, 2));
  EXPECT_EQ(delivered(*one, 1, *two, 200), 0u);
  EXPECT_GT(delivered(*two, 2, *one, 200), 100u);
  const LinkCounters link = two->packet_counters().at({1});
  EXPECT_EQ(link.dropped, link.sent);
  EXPECT_GT(link.sent, 100u);
  boss->publish(samples::mission());  // the coordinator's links have no faults
  EXPECT_TRUE(next<Mission>(*two));
  one->publish(samples::status(1));
  EXPECT_TRUE(next<StatusMessage>(*boss));
}

TEST_F(FaultyBusTest, ReliableBidsGetThroughALossyLink) {
  network_.reliable_bids = true;
  const auto one = agent(1), two = agent(2);
  LinkFault lossy;
  lossy.loss = 0.5;
  install(*two, lossy);
  ASSERT_TRUE(matched(*one, 1) && matched(*two, 1));
  for (std::uint32_t version = 1; version <= 20; ++version) {
    one->publish(samples::bids(1, version));
    const auto got = next<BidMessage>(*two);
    ASSERT_TRUE(got);
    EXPECT_EQ(got->statement.key.version, version);
  }
  EXPECT_GT(two->packet_counters().at({1}).dropped, 0u);
}

TEST_F(FaultyBusTest, DelaysPackets) {
  const auto one = agent(1), two = agent(2);
  ASSERT_TRUE(matched(*one, 1) && matched(*two, 1));
  LinkFault slow;
  slow.delay = Delay{Delay::Kind::fixed, 100'000'000, 0, 0};
  install(*two, slow);
  const auto start = Clock::now();
  one->publish(samples::bids(1));
  ASSERT_TRUE(next<BidMessage>(*two));
  EXPECT_GE(seconds_since(start), 0.1);
  EXPECT_GE(two->packet_counters().at({1}).delayed, 1u);
}

TEST_F(FaultyBusTest, CopiesReachDdsWhichTakesOne) {
  const auto one = agent(1), two = agent(2);
  ASSERT_TRUE(matched(*one, 1) && matched(*two, 1));
  LinkFault twice;
  twice.duplicate = 1;
  install(*two, twice);
  EXPECT_LE(delivered(*one, 1, *two, 50), 50u);
  EXPECT_GE(two->packet_counters().at({1}).duplicated, 40u);
}

TEST_F(FaultyBusTest, WhatIsOvertakenDdsDrops) {
  const auto one = agent(1), two = agent(2);
  ASSERT_TRUE(matched(*one, 1) && matched(*two, 1));
  LinkFault slow;
  slow.delay = Delay{Delay::Kind::uniform, 0, 100'000'000, 0};
  install(*two, slow);
  const std::uint32_t heard = delivered(*one, 1, *two, 200);
  EXPECT_GT(heard, 0u);
  EXPECT_LT(heard, 150u);
  EXPECT_EQ(two->packet_counters().at({1}).dropped, 0u);
}

TEST_F(FaultyBusTest, GoesWhilePacketsAreUnderWay) {
  const auto one = agent(1);
  auto two = agent(2);
  ASSERT_TRUE(matched(*one, 1) && matched(*two, 1));
  LinkFault slow;
  slow.delay = Delay{Delay::Kind::uniform, 0, 600'000'000'000, 0};
  install(*two, slow);
  for (std::uint32_t version = 1; version <= 200; ++version)
    one->publish(samples::bids(1, version));
  ASSERT_TRUE(eventually([&] { return two->packet_counters().at({1}).delayed > 100; }));
  two.reset();
  EXPECT_TRUE(matched(*one, 0));
}

}  // namespace
}  // namespace arcbid
