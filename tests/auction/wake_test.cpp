// SPDX-License-Identifier: GPL-3.0-or-later
// Agents on a perfect network in virtual time, every event and update on record: how often they
// wake, and that a replay of the events gives the same updates.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <map>

#include "core/auction/agent.hpp"
#include "tests/auction/fleet.hpp"

namespace arcbid::testing {
namespace {

constexpr TimeNs second = 1'000'000'000, delay = 1'000'000;

std::string text(const StatementKey& key) {
  return fmt::format("{}{}{} ", key.incarnation, key.dead ? '+' : '.', key.version);
}

std::string text(const std::vector<Belief>& beliefs) {
  std::string out;
  for (const Belief& b : beliefs)
    out += fmt::format("{}:{:a} ", b.winner.value_or(AgentId{}).value, b.bid);
  return out;
}

std::string text(const StatementBody& body) {
  if (const auto* table = std::get_if<Table>(&body))
    return text(table->beliefs) + fmt::format("{}", fmt::join(table->timestamps, " "));
  std::string out;
  for (const Claim& claim : std::get<Claims>(body).bundle)
    out += fmt::format("{}={:a} ", claim.task.value, claim.bid);
  return out;
}

std::string text(const std::vector<PathStop>& path) {
  std::string out;
  for (const PathStop& stop : path)
    out += fmt::format("{}{} ", stop.task.value, stop.reversed ? '<' : '>');
  return out;
}

std::string text(const Header& h) {
  return fmt::format("{}/{}/{} ", h.sender.value, h.incarnation, h.sequence);
}

std::string text(const StatusMessage& s) {
  std::string out =
      text(s.header) + fmt::format("phase {} round {} peers {} hash {:x} ", int(s.phase), s.round,
                                   s.matched_peers, s.view_hash);
  for (const AgentId id : s.ready) out += fmt::format("r{} ", id.value);
  out += s.whole ? "whole " : "new ";
  for (const Held& held : s.view) out += fmt::format("{}:{}", held.agent.value, text(held.key));
  for (const auto& [agent, beat] : s.heartbeats)
    out += fmt::format("{}:{}*{} ", agent.value, beat.incarnation, beat.counter);
  return out;
}

/// All of an update, to the last bit.
std::string text(const Update& u) {
  std::string out = fmt::format("wake {} {}{} {} ", u.wake_ns, u.started, u.agreement_lost,
                                u.refused.value_or(""));
  for (const auto& m : u.bids)
    out += "bid " + text(m.header) + text(m.statement.key) + text(m.statement.body);
  for (const auto& m : u.relays)
    out += fmt::format("relay {} ", m.statement.agent.value) + text(m.header) +
           text(m.statement.key) + text(m.statement.body);
  for (const auto& m : u.statuses) out += "status " + text(m);
  for (const AgentId id : u.died) out += fmt::format("died {} ", id.value);
  for (const AgentId id : u.returned) out += fmt::format("returned {} ", id.value);
  if (const auto& d = u.decision)
    out += fmt::format("round {} {} ", d->round, d->changed) + text(d->key) + text(d->body) +
           text(d->path);
  if (const auto& a = u.agreed)
    out += fmt::format("agreed {:x} ", a->view_hash) + text(a->winners) + text(a->path);
  return out;
}

class Wire {
 public:
  explicit Wire(Mission mission) : mission_(std::make_shared<const Mission>(std::move(mission))) {
    for (const Uav& uav : mission_->fleet)
      members_.emplace(uav.id, Member{fresh(uav.id), 0, 0, {}, {}});
  }

  /// Members that are `gone` neither wake nor hear.
  void run_for(TimeNs span_ns, std::vector<AgentId> gone = {}) {
    const TimeNs end = now_ns_ + span_ns;
    for (int steps = 0;; ++steps) {
      ASSERT_LT(steps, 20'000) << "a storm of messages";
      std::pair<TimeNs, std::optional<AgentId>> next{end, std::nullopt};
      for (const auto& [id, member] : members_)
        if (std::ranges::find(gone, id) == gone.end())
          next = std::min(next, {member.wake_ns, id}, sooner);
      if (!queue_.empty() && queue_.front().first < next.first) {
        const Event event = queue_.front().second;
        queue_.pop_front();
        now_ns_ = event.now_ns;
        for (const auto& [id, member] : members_)
          if (id != sender_of(event) && std::ranges::find(gone, id) == gone.end()) step(id, event);
      } else if (next.second) {
        now_ns_ = std::max(now_ns_, next.first);
        step(*next.second, {now_ns_, Tick{static_cast<std::uint32_t>(members_.size() - 1)}});
      } else {
        break;
      }
    }
    now_ns_ = end;
  }

  std::size_t steps(AgentId id) const { return members_.at(id).events.size(); }
  std::size_t wakes(AgentId id) const { return members_.at(id).wakes; }
  Phase phase(AgentId id) const { return members_.at(id).agent->phase(); }

  void expect_replay_is_identical(AgentId id) const {
    const Member& member = members_.at(id);
    const auto again = fresh(id);
    ASSERT_GT(member.events.size(), 10u);
    for (std::size_t n = 0; n < member.events.size(); ++n)
      ASSERT_EQ(text(again->step(member.events[n])), member.updates[n]) << "event " << n;
  }

 private:
  struct Member {
    std::unique_ptr<Agent> agent;
    TimeNs wake_ns;
    std::size_t wakes;
    std::vector<Event> events;
    std::vector<std::string> updates;
  };
  static bool sooner(const std::pair<TimeNs, std::optional<AgentId>>& a,
                     const std::pair<TimeNs, std::optional<AgentId>>& b) {
    return a.first < b.first;
  }
  static AgentId sender_of(const Event& event) {
    return std::visit(
        [](const auto& what) {
          if constexpr (requires { what.header; }) return what.header.sender;
          return AgentId{};
        },
        event.what);
  }
  std::unique_ptr<Agent> fresh(AgentId id) const {
    return std::make_unique<Agent>(id, 700 + id.value, mission_,
                                   std::make_shared<StraightTransit>(), 0);
  }
  void step(AgentId id, const Event& event) {
    Member& member = members_.at(id);
    const Update update = member.agent->step(event);
    const bool ticked = std::holds_alternative<Tick>(event.what);
    EXPECT_GE(update.wake_ns, now_ns_ + ticked) << "agent " << id.value << " would spin";
    member.wake_ns = update.wake_ns;
    member.wakes += ticked;
    member.events.push_back(event);
    member.updates.push_back(text(update));
    for (const auto& message : update.bids) send(message);
    for (const auto& message : update.relays) send(message);
    for (const auto& message : update.statuses) send(message);
  }
  void send(const auto& message) {
    queue_.emplace_back(now_ns_ + delay, Event{now_ns_ + delay, message});
  }

  std::shared_ptr<const Mission> mission_;
  std::map<AgentId, Member> members_;
  std::deque<std::pair<TimeNs, Event>> queue_;
  TimeNs now_ns_ = 0;
};

/// Heartbeats in 10 s of quiet: one every eighth of a lease of 2 s, and one for the way rounded.
constexpr std::size_t heartbeats = 41;

TEST(Wakes, OfALoneAgentAreItsHeartbeatsOnceItHasAgreed) {
  Wire wire(random_mission(1, 1, 5));
  wire.run_for(second);
  ASSERT_EQ(wire.phase({1}), Phase::agreed);
  const std::size_t before = wire.steps({1});
  wire.run_for(10 * second);
  EXPECT_LE(wire.steps({1}) - before, heartbeats);
  EXPECT_GE(wire.steps({1}) - before, heartbeats - 2);
}

TEST(Wakes, OfAFleetAreItsHeartbeatsOnceItHasAgreed) {
  Wire wire(random_mission(1, 4, 8));
  wire.run_for(2 * second);
  std::map<AgentId, std::size_t> wakes, steps;
  for (const AgentId id : {AgentId{1}, AgentId{2}, AgentId{3}, AgentId{4}}) {
    ASSERT_EQ(wire.phase(id), Phase::agreed);
    wakes[id] = wire.wakes(id);
    steps[id] = wire.steps(id);
  }
  wire.run_for(10 * second);
  for (const auto& [id, count] : wakes) {
    EXPECT_LE(wire.wakes(id) - count, heartbeats);
    EXPECT_LE(wire.steps(id) - steps[id], 4 * heartbeats) << "one for each heartbeat of anybody";
  }
}

TEST(Wakes, AreFewWhileAnAgentWaitsForPeersThatDoNotCome) {
  Wire wire(random_mission(1, 3, 5));
  wire.run_for(9 * second, {{2}, {3}});
  EXPECT_EQ(wire.phase({1}), Phase::waiting_for_peers);
  EXPECT_LE(wire.steps({1}), heartbeats);
}

TEST(Wakes, AreFewAfterTheDeathOfAPeer) {
  Wire wire(random_mission(1, 3, 5));
  wire.run_for(2 * second);
  wire.run_for(5 * second, {{3}});  // the lease runs out, the tombstone goes round
  ASSERT_EQ(wire.phase({1}), Phase::agreed);
  const std::size_t before = wire.wakes({1});
  wire.run_for(10 * second, {{3}});
  EXPECT_LE(wire.wakes({1}) - before, heartbeats);
}

TEST(Wakes, ComeAtMostOnceATickWhileAPeerLacksSomething) {
  Wire wire(random_mission(1, 3, 5));
  wire.run_for(50'000'000);  // in the midst of the auction
  const std::size_t before = wire.wakes({1});
  wire.run_for(second, {{3}});  // it is missed only after two
  EXPECT_LE(wire.wakes({1}) - before, 60u);
}

class Replay : public ::testing::TestWithParam<PolicyKind> {};

TEST_P(Replay, GivesTheSameUpdatesBitForBit) {
  Mission mission = random_mission(6, 4, 10);
  mission.auction.policy = GetParam();
  Wire wire(mission);
  wire.run_for(second);
  wire.run_for(4 * second, {{3}});  // long enough to be buried
  wire.run_for(2 * second);         // and back, to refute it
  for (const Uav& uav : mission.fleet) {
    EXPECT_EQ(wire.phase(uav.id), Phase::agreed);
    wire.expect_replay_is_identical(uav.id);
  }
}

INSTANTIATE_TEST_SUITE_P(Under, Replay, ::testing::Values(PolicyKind::claims, PolicyKind::cbba),
                         [](const auto& policy) {
                           return policy.param == PolicyKind::claims ? "Claims" : "PublishedCbba";
                         });

}  // namespace
}  // namespace arcbid::testing
