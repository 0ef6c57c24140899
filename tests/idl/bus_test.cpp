// SPDX-License-Identifier: GPL-3.0-or-later
#include "idl/bus.hpp"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <thread>

#include "core/base/error.hpp"
#include "tests/idl/bus_fixture.hpp"
#include "tests/idl/equal.hpp"
#include "tests/idl/samples.hpp"

namespace arcbid {
namespace {

/// Publishes until it has arrived (best effort may lose one) and compares bit for bit.
template <class Message>
void expect_arrives(Bus& from, Bus& to, const Message& message) {
  for (int attempt = 0; attempt < 20; ++attempt) {
    from.publish(message);
    const auto deadline = Clock::now() + 500ms;
    while (Clock::now() < deadline)
      for (const Received& received : to.wait(deadline - Clock::now()))
        if (const auto* got = std::get_if<Message>(&received)) {
          EXPECT_TRUE(same(*got, message));
          return;
        }
  }
  FAIL() << "did not arrive";
}

class EveryKind : public BusTest, public testing::WithParamInterface<bool> {};

TEST_P(EveryKind, ArrivesUnchanged) {
  network_.reliable_bids = GetParam();
  const auto boss = coordinator(), one = agent(1), two = agent(2);
  ASSERT_TRUE(matched(*one, 1) && matched(*two, 1) && matched(*boss, 2));
  expect_arrives(*boss, *one, samples::mission());
  expect_arrives(*boss, *two, samples::control());
  expect_arrives(*one, *two, samples::bids(1));
  expect_arrives(*two, *one, samples::relay(2, 3));
  expect_arrives(*two, *one, samples::status(2));
  expect_arrives(*two, *boss, samples::status(2));
  expect_arrives(*one, *boss, samples::route(1));
  EXPECT_EQ(boss->counters().dropped + one->counters().dropped + two->counters().dropped, 0u);
  EXPECT_GE(one->counters().sent, 2u);
  EXPECT_GT(one->counters().bytes_sent, 100u);
  EXPECT_GE(one->counters().received, 3u);
}
INSTANTIATE_TEST_SUITE_P(, EveryKind, testing::Bool(),
                         [](const auto& kind) { return kind.param ? "Reliable" : "BestEffort"; });

TEST_F(BusTest, ReliableBidsReachALateJoiner) {
  network_.reliable_bids = true;
  const auto one = agent(1);
  one->publish(samples::bids(1, 1));
  one->publish(samples::bids(1, 2));
  const auto late = agent(2);
  const auto got = next<BidMessage>(*late);
  ASSERT_TRUE(got);
  EXPECT_EQ(got->statement.key.version, 2u);
}

TEST_F(BusTest, OwnSamplesAreNotDelivered) {
  const auto one = agent(1), two = agent(2);
  ASSERT_TRUE(matched(*one, 1) && matched(*two, 1));
  for (std::uint32_t v = 0; v < 20; ++v) one->publish(samples::bids(1, v));
  expect_arrives(*one, *two, samples::relay(1, 2));
  expect_arrives(*one, *two, samples::status(1));
  EXPECT_TRUE(one->wait(100ms).empty());
  EXPECT_EQ(one->counters().received, 0u);
}

TEST_F(BusTest, MatchedAgentsGoUpAndDown) {
  const auto boss = coordinator(), one = agent(1);
  EXPECT_TRUE(matched(*boss, 1));
  EXPECT_EQ(one->matched_agents(), 0u);  // the coordinator is none
  auto two = agent(2);
  auto three = agent(3);
  EXPECT_TRUE(matched(*one, 2) && matched(*boss, 3));
  two.reset();
  EXPECT_TRUE(matched(*one, 1) && matched(*three, 1) && matched(*boss, 2));
  three.reset();
  EXPECT_TRUE(matched(*one, 0) && matched(*boss, 1));
  two = agent(2);
  EXPECT_TRUE(matched(*one, 1) && matched(*boss, 2));
}

TEST_F(BusTest, ASecondLifeUnderTheSameNameCountsOnce) {
  const auto one = agent(1), two = agent(2), again = agent(2), three = agent(3);
  EXPECT_TRUE(matched(*one, 2));
  std::this_thread::sleep_for(200ms);
  EXPECT_EQ(one->matched_agents(), 2u);
}

TEST_F(BusTest, DomainsDoNotMeet) {
  const DomainLease elsewhere(kFleet);
  const auto one = agent(1), two = agent(2);
  const Bus stranger(network_, elsewhere.domain(), AgentId{3}, kFleet);
  ASSERT_TRUE(matched(*one, 1) && matched(*two, 1));
  std::this_thread::sleep_for(500ms);
  EXPECT_EQ(one->matched_agents(), 1u);
  EXPECT_EQ(stranger.matched_agents(), 0u);
}

TEST_F(BusTest, WakeEndsAWait) {
  const auto one = agent(1);
  std::thread waker([&] {
    std::this_thread::sleep_for(50ms);
    one->wake();
  });
  const auto start = Clock::now();
  EXPECT_TRUE(one->wait(std::chrono::nanoseconds::max()).empty());
  EXPECT_LT(seconds_since(start), 5);
  waker.join();
}

TEST_F(BusTest, UnusableSettingsAreInputErrors) {
  network_.interface_address = "192.0.2.1";  // TEST-NET-1: nobody's
  EXPECT_THROW(agent(1), InputError);
  network_.interface_address = "localhost";
  EXPECT_THROW(agent(1), InputError);
  network_.interface_address = "0.0.0.0";
  EXPECT_THROW(agent(1), InputError);
  network_.interface_address = "127.0.0.1";
  network_.transport = TransportKind::discovery_server;
  network_.server_address = "300.0.0.1";
  EXPECT_THROW(agent(1), InputError);
  EXPECT_THROW(Bus({}, 232, AgentId{1}, 4), InputError);
}

TEST_F(BusTest, NoSharedMemoryAndNoMulticast) {
  const auto boss = coordinator(), one = agent(1);
  ASSERT_TRUE(matched(*boss, 1));
  expect_arrives(*boss, *one, samples::mission());
  std::string maps;
  std::ifstream file("/proc/self/maps");
  std::getline(file, maps, '\0');
  EXPECT_EQ(maps.find("/dev/shm"), std::string::npos);
  for (const auto& fd : std::filesystem::directory_iterator("/proc/self/fd")) {
    std::error_code gone;
    const auto target = std::filesystem::read_symlink(fd, gone);
    EXPECT_FALSE(target.string().starts_with("/dev/shm")) << target;
  }
  std::ifstream groups("/proc/self/net/igmp");
  std::string text;
  std::getline(groups, text, '\0');
  EXPECT_EQ(text.find("0100FFEF"), std::string::npos);  // 239.255.0.1, RTPS's group
}

TEST_F(BusTest, ReachesAnotherProcessAndOutlivesIt) {
  const auto one = agent(1);
  const std::string command =
      std::string(ARCBID_BUS_PEER) + " " + std::to_string(lease_.domain()) + " 2";
  std::FILE* peer = popen(command.c_str(), "w");
  ASSERT_NE(peer, nullptr);
  ASSERT_TRUE(matched(*one, 1));
  std::vector<double> round_trips_s;
  for (std::uint32_t version = 1; version <= 200; ++version) {
    const auto start = Clock::now();
    one->publish(samples::bids(1, version));
    const auto echo = next<RelayMessage>(*one, 1s);
    if (echo && echo->statement.key.version == version)
      round_trips_s.push_back(seconds_since(start));
  }
  ASSERT_GT(round_trips_s.size(), 100u);
  std::sort(round_trips_s.begin(), round_trips_s.end());
  std::printf("one hop, process to process: p50 %.0f us, p99 %.0f us\n",
              5e5 * round_trips_s[round_trips_s.size() / 2],
              5e5 * round_trips_s[round_trips_s.size() * 99 / 100]);
  EXPECT_EQ(pclose(peer), 0);  // the end of its input ends it
  EXPECT_TRUE(matched(*one, 0));
}

class Discovery : public BusTest, public testing::WithParamInterface<std::uint32_t> {};

TEST_P(Discovery, WholeFleetMatches) {
  const std::uint32_t agents = GetParam();
  const auto start = Clock::now();
  std::vector<std::unique_ptr<Bus>> buses;
  for (std::uint32_t id = 1; id <= agents; ++id) buses.push_back(agent(id));
  for (const auto& bus : buses)
    EXPECT_TRUE(eventually([&] { return bus->matched_agents() == agents - 1; }, 30s));
  const double matched_s = seconds_since(start);
  const auto teardown = Clock::now();
  buses.clear();
  std::printf("%u agents: all matched after %.2f s, torn down in %.2f s\n", agents, matched_s,
              seconds_since(teardown));
}
INSTANTIATE_TEST_SUITE_P(, Discovery, testing::Values(4, 16), testing::PrintToStringParamName());

}  // namespace
}  // namespace arcbid
