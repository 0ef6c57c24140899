// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/auction/agent.hpp"
#include "tests/auction/fleet.hpp"

namespace arcbid::testing {

inline constexpr TimeNs second = 1'000'000'000;
inline constexpr std::uint64_t own_life = 500;
inline constexpr AgentId first{1}, self{2}, third{3};
inline constexpr std::size_t at_first = 0, at_self = 1, at_third = 2;  // roster positions

/// Agent 2 of three; the test plays the other two.
class AgentTest : public ::testing::Test {
 protected:
  /// Without an audit a test bids what it likes.
  explicit AgentTest(PolicyKind policy = PolicyKind::claims, bool audit_bids = false) {
    Mission draft = random_mission(1, 3, 4);
    draft.auction.policy = policy;
    draft.auction.audit_bids = audit_bids;
    mission = std::make_shared<const Mission>(draft);
    agent.emplace(self, own_life, mission, std::make_shared<StraightTransit>(), 0);
  }

  Header header(AgentId sender) {
    return {sender, life(sender), ++sequence[sender], digest(*mission), agent->tasks().digest};
  }
  static std::uint64_t life(AgentId id) { return 600 + id.value; }

  Update hear(const auto& message) { return note(agent->step({now, message})); }
  Update tick(std::uint32_t matched_peers = 2) {
    Update update = hear(Tick{matched_peers});
    // At the start the silence of those never heard is looked at in a tick of its own.
    EXPECT_TRUE(wake_ns > now || update.started) << "a caller that obeys would spin";
    return update;
  }

  Statement claims(AgentId id, std::uint32_t version, std::vector<Claim> bundle = {}) {
    return {id, {life(id), false, version}, Claims{std::move(bundle)}};
  }
  BidMessage bid(Statement statement) {
    const AgentId sender = statement.agent;
    return {header(sender), std::move(statement)};
  }
  /// A status of a peer that holds what the agent under test holds.
  StatusMessage status(AgentId sender, Phase phase = Phase::auction,
                       std::uint32_t matched_peers = 2) {
    StatusMessage message;
    message.header = header(sender);
    message.phase = phase;
    message.matched_peers = matched_peers;
    for (std::size_t k = 0; k < 3; ++k) {
      const AgentId member = agent->view().roster()[k];
      message.view.push_back({member, agent->view().key(k)});
      message.heartbeats.push_back({member, {}});
    }
    return message;
  }

  void start() {
    tick();
    hear(status(first, Phase::waiting_for_peers));
    hear(status(third, Phase::waiting_for_peers));
    ASSERT_EQ(agent->phase(), Phase::auction);
  }
  /// Ticks when the agent asks for it until `done` with an update: the last one.
  template <class Done>
  Update tick_until(Done done, std::uint32_t matched_peers = 2) {
    Update update;
    for (int step = 0; step < 1000; ++step) {
      now = std::max(now, wake_ns);
      update = tick(matched_peers);
      if (done(update)) return update;
    }
    ADD_FAILURE() << "nothing came of 1000 ticks";
    return update;
  }
  /// Lets the agent do what it has to do, for less than a lease.
  void settle() {
    const TimeNs end = now + second / 2;
    for (int step = 0; step < 200 && wake_ns < end; ++step) {
      now = std::max(now, wake_ns);
      tick();
    }
  }
  /// Both peers have stated an empty bundle, and were ready for what the agent then holds.
  Update agree() {
    start();
    hear(bid(claims(first, 1)));
    hear(bid(claims(third, 1)));
    settle();
    StatusMessage message = status(first);
    message.view_hash = agent->view().hash();
    message.ready = {first, third};
    return hear(message);
  }

  std::shared_ptr<const Mission> mission;
  std::optional<Agent> agent;
  std::map<AgentId, std::uint64_t> sequence;
  TimeNs now = 0, wake_ns = 0;

 private:
  Update note(Update update) {
    EXPECT_GE(update.wake_ns, now);
    wake_ns = update.wake_ns;
    return update;
  }
};

}  // namespace arcbid::testing
