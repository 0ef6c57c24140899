// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/launcher/monitor.hpp"

#include <gtest/gtest.h>

namespace arcbid {
namespace {

using nlohmann::json;

json agreed(const std::string& hash, std::uint32_t round, double time_s) {
  return {{"event", "agreed"}, {"view_hash", hash}, {"round", round}, {"time_s", time_s}};
}

json routed(const std::string& hash, const std::vector<int>& members) {
  return {{"event", "routed"}, {"view_hash", hash}, {"members", members}};
}

class MonitorTest : public ::testing::Test {
 protected:
  void finish(std::uint32_t id, const std::string& hash, const std::vector<int>& members) {
    monitor.heard(id, agreed(hash, 4 + id, 0.5 * id));
    monitor.heard(id, routed(hash, members));
  }
  Monitor monitor{{{1}, {2}, {3}}};
};

TEST_F(MonitorTest, HasAnOutcomeOnceEveryMemberIsRoutedUnderOneAgreement) {
  finish(1, "a", {1, 2, 3});
  finish(2, "a", {1, 2, 3});
  EXPECT_FALSE(monitor.outcome());
  finish(3, "a", {1, 2, 3});
  const auto outcome = monitor.outcome();
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->view_hash, "a");
  EXPECT_EQ(outcome->members, (std::set<std::uint32_t>{1, 2, 3}));
  EXPECT_EQ(outcome->rounds, 7u);
  EXPECT_DOUBLE_EQ(outcome->agreed_s, 1.5);
}

TEST_F(MonitorTest, CountsTheAuctionFromTheFirstStart) {
  for (const std::uint32_t id : {1u, 2u, 3u})
    monitor.heard(id, {{"event", "started"}, {"time_s", 0.4 - 0.1 * id}});
  for (const std::uint32_t id : {1u, 2u, 3u}) finish(id, "a", {1, 2, 3});
  ASSERT_TRUE(monitor.outcome());
  EXPECT_DOUBLE_EQ(monitor.outcome()->auction_s, 1.5 - 0.1);
}

TEST_F(MonitorTest, DoesNotMixTwoAgreements) {
  finish(1, "a", {1, 2, 3});
  finish(2, "b", {1, 2, 3});
  finish(3, "a", {1, 2, 3});
  EXPECT_FALSE(monitor.outcome());
}

TEST_F(MonitorTest, TakesTheLatestAgreementAfterADeath) {
  for (const std::uint32_t id : {1u, 2u, 3u}) finish(id, "a", {1, 2, 3});
  monitor.heard(1, {{"event", "died"}, {"agents", {2}}});
  monitor.heard(1, {{"event", "reopened"}});
  monitor.heard(3, {{"event", "reopened"}});
  EXPECT_FALSE(monitor.outcome()) << "the routes so far are void";
  EXPECT_TRUE(monitor.agents().at(2).gone);
  finish(1, "b", {1, 3});
  finish(3, "b", {1, 3});
  ASSERT_TRUE(monitor.outcome());
  EXPECT_EQ(monitor.outcome()->members, (std::set<std::uint32_t>{1, 3}));
}

TEST_F(MonitorTest, AddsUpTheNewestTrafficOfEveryProcess) {
  const auto traffic = [](int n) {
    return json{
        {"event", "traffic"}, {"sent", n}, {"received", 2 * n}, {"dropped", 0}, {"bytes", 9}};
  };
  monitor.heard(0, traffic(1));
  monitor.heard(1, traffic(10));
  monitor.heard(1, traffic(20));
  EXPECT_EQ(monitor.traffic().sent, 21u);
  EXPECT_EQ(monitor.traffic().received, 42u);
  EXPECT_EQ(monitor.traffic().bytes, 18u);
}

TEST_F(MonitorTest, CountsRefusalsAndKeepsTheFirst) {
  monitor.heard(1, {{"event", "refused"}, {"reason", "a bid that is no number"}});
  monitor.heard(2, {{"event", "refused"}, {"reason", "another"}});
  EXPECT_EQ(monitor.refused(), 2u);
  EXPECT_EQ(monitor.first_refusal(), "a bid that is no number");
}

TEST_F(MonitorTest, IgnoresWhatItDoesNotKnow) {
  monitor.heard(1, {{"event", "a later version's event"}, {"x", 1}});
  monitor.heard(9, {{"event", "up"}});
  EXPECT_FALSE(monitor.outcome());
}

}  // namespace
}  // namespace arcbid
