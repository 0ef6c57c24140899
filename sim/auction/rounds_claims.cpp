// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/auction/policy.hpp"
#include "core/auction/readiness.hpp"
#include "core/auction/view.hpp"
#include "core/base/error.hpp"
#include "sim/auction/difference.hpp"
#include "sim/auction/orders.hpp"
#include "sim/auction/protocol.hpp"

namespace arcbid {
namespace {

/// Statements flood: an agent passes on what it has learnt since its last message, where one of its
/// neighbours can have it neither from its author nor from whom it came. Nothing is lost here, so
/// that an agent need not say what it holds, and says bundles as differences to what it said last:
/// with bids, and where that is asked for as orders of tasks, from which the neighbours recompute
/// the bids.
class ClaimsRounds final : public RoundsProtocol {
 public:
  explicit ClaimsRounds(const RoundsWorld& world) : world_(world) {
    const std::vector<AgentId> roster = world.roster();
    for (const Uav& uav : world.instance.fleet)
      agents_.push_back(
          {make_policy(world.instance.tasks, uav, roster, world.settings, world.transit),
           View(roster), Readiness(roster.size(), agents_.size()),
           std::vector<bool>(roster.size(), false),
           std::vector<std::vector<std::size_t>>(roster.size()), std::vector<Said>(roster.size())});
    for (std::vector<BundleReplay>* side : {&senders_, &receivers_})
      for (const Uav& uav : world.instance.fleet)
        if (world.encoding == Encoding::orders)
          side->push_back(make_replay(world.instance.tasks, uav, world.settings, world.transit));
  }

  bool play(Traffic& traffic) override {
    bool changed = false;
    for (std::size_t i = 0; i < agents_.size(); ++i) changed |= decide(i);
    std::vector<Message> said;
    for (std::size_t i = 0; i < agents_.size(); ++i) said.push_back(speak(i, traffic));
    for (std::size_t i = 0; i < agents_.size(); ++i)
      for (const std::size_t k : world_.neighbours[i]) hear(i, k, said[k]);
    return changed;
  }

  bool proven() const override {
    return std::all_of(agents_.begin(), agents_.end(), [](const Member& agent) {
      const auto& set = agent.readiness.set();
      return std::all_of(set.begin(), set.end(), [](bool ready) { return ready; });
    });
  }

  bool agreed() const override {
    return std::all_of(agents_.begin(), agents_.end(), [&](const Member& agent) {
      return agent.policy->winners(agent.view) ==
             agents_.front().policy->winners(agents_.front().view);
    });
  }

  std::vector<std::vector<PathStop>> paths() const override {
    std::vector<std::vector<PathStop>> paths;
    for (const Member& agent : agents_) paths.push_back(agent.policy->path());
    return paths;
  }

 private:
  struct Member {
    std::unique_ptr<Policy> policy;
    View view;
    Readiness readiness;
    std::vector<bool> news;                    // by author: not said yet
    std::vector<std::vector<std::size_t>> by;  // by author: neighbours that the newest came from
    std::vector<Said> said;                    // by author: what the neighbours have
    bool undecided = true;
    std::uint32_t version = 0;
    std::uint64_t hash = 0;
    bool ready_grew = false;
  };
  struct Message {
    std::vector<Statement> statements;
    std::uint64_t hash = 0;
    std::vector<bool> ready;
    bool silent = false;
  };

  bool decide(std::size_t i) {
    Member& agent = agents_[i];
    if (!agent.undecided) return false;
    const Decision decision = agent.policy->decide(agent.view);
    if (decision.changed || agent.version == 0) {
      const AgentId self = world_.instance.fleet[i].id;
      agent.view.merge({self, {1, false, ++agent.version}, agent.policy->statement()});
      agent.news[i] = true;
      agent.readiness.view_changed();
    }
    agent.hash = agent.view.hash();
    agent.readiness.decided(agent.hash);
    agent.undecided = false;
    agent.ready_grew = true;
    return decision.changed;
  }

  bool wanted(std::size_t i, std::size_t author) const {
    const auto has = [](const std::vector<std::size_t>& all, std::size_t one) {
      return std::find(all.begin(), all.end(), one) != all.end();
    };
    const auto& direct = world_.neighbours[author];
    const auto& by = agents_[i].by[author];
    const auto& neighbours = world_.neighbours[i];
    return std::any_of(neighbours.begin(), neighbours.end(), [&](std::size_t k) {
      return k != author && (i == author || (!has(direct, k) && !has(by, k)));
    });
  }

  Message speak(std::size_t i, Traffic& traffic) {
    Member& agent = agents_[i];
    Message message{{}, agent.hash, agent.readiness.set(), false};
    const std::uint64_t frame = message_bytes + hash_bytes + agents_.size() / 8;
    std::uint64_t bytes = frame, difference_bytes = frame, order_bytes = frame;
    for (std::size_t author = 0; author < agents_.size(); ++author) {
      const bool news = agent.news[author];
      agent.news[author] = false;
      if (!news || !wanted(i, author)) continue;
      const Statement& statement = agent.view.of(author);
      Said& said = agent.said[author];
      const Said now{statement.key, std::get<Claims>(statement.body).bundle};
      const Difference what = difference(said.bundle, now.bundle);
      difference_bytes += statement_bytes + what.bytes();
      if (world_.encoding == Encoding::orders) order_bytes += say_order(author, said, now);
      said = {now.key, restored(what, said.bundle)};  // as every neighbour does
      bytes += statement_bytes + claim_bytes * said.bundle.size();
      message.statements.push_back({statement.agent, said.key, Claims{said.bundle}});
    }
    if (!message.statements.empty()) {
      bytes += timestamp_bytes * agents_.size();
      order_bytes += (agents_.size() + 7) / 8;  // a bit for each author: who of them is told of
    }
    message.silent = message.statements.empty() && !agent.ready_grew;
    agent.ready_grew = false;
    if (message.silent) return message;
    traffic.messages += world_.neighbours[i].size();
    traffic.sends += 1;
    traffic.bytes += bytes;
    traffic.difference_bytes += difference_bytes;
    if (world_.encoding == Encoding::orders) traffic.order_bytes += order_bytes;
    return message;
  }

  /// What it costs; and every neighbour has then exactly what was said.
  std::uint64_t say_order(std::size_t author, const Said& before, const Said& now) {
    const Bytes bytes = encode(before, now, senders_[author]);
    check(decode(bytes, before, world_.tasks(), receivers_[author]) == now,
          "an order restores its statement");
    return bytes.size();
  }

  void hear(std::size_t i, std::size_t k, const Message& message) {
    Member& agent = agents_[i];
    if (message.silent) return;
    for (const Statement& statement : message.statements) {
      const auto author = *agent.view.position(statement.agent);
      if (statement.key == agent.view.key(author)) agent.by[author].push_back(k);
      if (statement.key <= agent.view.key(author)) continue;
      agent.view.merge(statement);
      agent.by[author] = {k};
      agent.news[author] = true;
      agent.undecided = true;
      agent.readiness.view_changed();
    }
    if (agent.readiness.heard(k, message.hash, message.ready)) agent.ready_grew = true;
  }

  const RoundsWorld& world_;
  std::vector<Member> agents_;
  std::vector<BundleReplay> senders_, receivers_;  // by author; empty: not asked for
};

}  // namespace

std::unique_ptr<RoundsProtocol> claims_rounds(const RoundsWorld& world) {
  return std::make_unique<ClaimsRounds>(world);
}

}  // namespace arcbid
