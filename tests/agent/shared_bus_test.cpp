// SPDX-License-Identifier: GPL-3.0-or-later
// Several agents on one bus, over real Fast DDS.
#include "agent/shared_bus.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "core/io/domain/domain.hpp"

namespace arcbid {
namespace {

using namespace std::chrono_literals;

BidMessage bid_of(std::uint32_t agent, std::uint64_t sequence) {
  return {{{agent}, 7, sequence, 1, 1}, {{agent}, {7, false, 1}, Claims{{{{0}, -1.0}}}}};
}

class SharedBusTest : public ::testing::Test {
 protected:
  static constexpr std::uint32_t fleet = 3;

  bool all_matched() {
    const auto deadline = std::chrono::steady_clock::now() + 20s;
    while (together_.matched_agents() < 2 || alone_.matched_agents() < 2) {
      if (std::chrono::steady_clock::now() > deadline) return false;
      std::this_thread::sleep_for(2ms);
    }
    return true;
  }
  /// The first bid that arrives for `agent` at `bus`.
  static std::optional<BidMessage> bid_at(SharedBus& bus, AgentId agent) {
    const auto deadline = std::chrono::steady_clock::now() + 10s;
    while (std::chrono::steady_clock::now() < deadline) {
      for (const Received& received : bus.take(agent))
        if (const auto* bid = std::get_if<BidMessage>(&received)) return *bid;
      bus.wait(10ms);
    }
    return std::nullopt;
  }

  DomainLease lease_{fleet};
  SharedBus together_{{}, lease_.domain(), {{1}, {2}}, fleet, FaultTier::messages};
  SharedBus alone_{{}, lease_.domain(), {{3}}, fleet, FaultTier::messages};
};

TEST_F(SharedBusTest, CountsEveryAgentOfAProcessAsAPeer) {
  EXPECT_TRUE(all_matched()) << together_.matched_agents() << ", " << alone_.matched_agents();
}

TEST_F(SharedBusTest, TellsTheOthersOfTheProcessAtOnceAndTheRestOverDds) {
  ASSERT_TRUE(all_matched());
  together_.publish({1}, bid_of(1, 5));
  const std::vector<Received> at_second = together_.take({2});
  ASSERT_EQ(at_second.size(), 1u);
  EXPECT_EQ(std::get<BidMessage>(at_second[0]).header.sequence, 5u);
  EXPECT_TRUE(together_.take({1}).empty()) << "nobody hears itself";
  const auto at_third = bid_at(alone_, {3});
  ASSERT_TRUE(at_third);
  EXPECT_EQ(at_third->header.sender, AgentId{1});
}

TEST_F(SharedBusTest, GivesWhatArrivesToEveryAgentOfTheProcess) {
  ASSERT_TRUE(all_matched());
  alone_.publish({3}, bid_of(3, 9));
  for (const std::uint32_t agent : {1u, 2u}) {
    const auto bid = bid_at(together_, {agent});
    ASSERT_TRUE(bid) << agent;
    EXPECT_EQ(bid->header.sequence, 9u);
  }
}

TEST_F(SharedBusTest, CountsForEachAgentWhatItSaidItself) {
  ASSERT_TRUE(all_matched());
  together_.publish({1}, bid_of(1, 1));
  together_.publish({1}, bid_of(1, 2));
  together_.publish({2}, bid_of(2, 1));
  EXPECT_EQ(together_.counters({1}).sent, 2u);
  EXPECT_EQ(together_.counters({2}).sent, 1u);
  EXPECT_EQ(together_.counters({1}).received, 1u);
  EXPECT_EQ(together_.counters({2}).received, 2u);
  EXPECT_EQ(together_.counters({1}).bytes_sent, 2 * together_.counters({2}).bytes_sent);
}

}  // namespace
}  // namespace arcbid
