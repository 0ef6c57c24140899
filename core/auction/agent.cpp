// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/auction/agent.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/auction/roster.hpp"
#include "core/base/error.hpp"

namespace arcbid {
namespace {

constexpr TimeNs resend_ticks = 4;    // own statements, until everybody confirmed them
constexpr TimeNs patience_ticks = 8;  // before somebody else's statement is relayed

TaskSet split_as_told(const Mission& mission) {
  return split(mission.arcs, mission.auction.split_m, mission.auction.max_tasks);
}

}  // namespace

Agent::Agent(AgentId self, std::uint64_t incarnation, std::shared_ptr<const Mission> mission,
             std::shared_ptr<const Transit> transit, TimeNs now_ns)
    : self_(self),
      incarnation_(incarnation),
      mission_(std::move(mission)),
      transit_(std::move(transit)),
      tasks_(split_as_told(*mission_)),
      view_(roster_of(*mission_)),
      me_(view_.position(self).value()),
      expected_{digest(*mission_),        tasks_.digest,
                tasks_.tasks.size(),      self,
                mission_->auction.policy, mission_->auction.bundle_limit},
      audit_(tasks_, mission_->fleet, mission_->auction, *transit_),
      policy_(make_policy(tasks_, uav_of(*mission_, self), view_.roster(), mission_->auction,
                          *transit_)),
      membership_(view_.roster().size(), me_, now_ns),
      readiness_(view_.roster().size(), me_),
      dissemination_(view_.roster().size(), me_,
                     {.resend_ns = resend_ticks * mission_->auction.tick_ns,
                      .patience_ns = patience_ticks * mission_->auction.tick_ns}),
      now_ns_(now_ns),
      born_ns_(now_ns),
      present_(view_.roster().size(), false),
      decided_ns_(now_ns - mission_->auction.tick_ns),
      spoke_ns_(view_.roster().size()),
      status_sent_ns_(now_ns - mission_->auction.tick_ns),
      whole_sent_ns_(now_ns - mission_->auction.lease_ns) {
  check(incarnation != 0, "an agent has a life");
  is_prepared_ = policy_->prepare();
}

Update Agent::step(const Event& event) {
  Update update;
  now_ns_ = std::max(now_ns_, event.now_ns);
  std::visit([&](const auto& what) { handle(what, update); }, event.what);
  if (phase_ == Phase::waiting_for_peers) start_if_everybody_is_here(update);
  if (phase_ != Phase::waiting_for_peers) {
    const bool all_was_heard = std::holds_alternative<Tick>(event.what);
    if (undecided_ && all_was_heard && round_is_over()) decide(update);
    prove(update);
  }
  send(update);
  update.wake_ns = next_wake();
  return update;
}

/// Only a tick may find somebody silent: it comes when all that has arrived was heard, so that
/// after a pause of its own an agent does not bury those whose heartbeats wait in the queue.
void Agent::handle(const Tick& tick, Update& update) {
  if (tick.matched_peers != matched_peers_) status_is_news_ = true;
  matched_peers_ = tick.matched_peers;
  if (phase_ != Phase::waiting_for_peers) bury_the_silent(update);
}

void Agent::handle(const BidMessage& bid, Update& update) {
  if (!accept(bid.header, update)) return;
  if (bid.statement.agent != bid.header.sender)
    update.refused = "a bid in another agent's name";
  else
    learn(bid.statement, update);
}

void Agent::handle(const RelayMessage& relay, Update& update) {
  if (accept(relay.header, update)) learn(relay.statement, update);
}

void Agent::handle(const StatusMessage& status, Update& update) {
  if (status.header.mission_digest == 0 && view_.position(status.header.sender)) return;
  const auto k = accept(status.header, update);
  if (!k) return;
  update.refused = refusal(status, view_);
  if (update.refused) return;
  present_[*k] =
      status.phase > Phase::waiting_for_peers || status.matched_peers + 1 >= view_.roster().size();
  auction_is_on_ = auction_is_on_ || status.phase > Phase::waiting_for_peers;
  hear_what_is_held(*k, status, update);
  std::vector<bool> ready(view_.roster().size(), false);
  for (const AgentId agent : status.ready) ready[*view_.position(agent)] = true;
  if (readiness_.heard(*k, status.view_hash, std::move(ready))) status_is_news_ = true;
}

void Agent::hear_what_is_held(std::size_t k, const StatusMessage& status, Update& update) {
  const Heartbeat stamp{status.header.incarnation, status.header.sequence};
  membership_.heard(k, stamp, now_ns_);
  for (const auto& [agent, heartbeat] : status.heartbeats) {
    if (agent != self_)
      membership_.heard(*view_.position(agent), heartbeat, now_ns_);
    else if (heartbeat.incarnation > incarnation_)
      refute({.incarnation = heartbeat.incarnation}, update);
  }
  std::vector<Dissemination::Holding> holdings;
  for (const auto& [agent, key] : status.view) {
    holdings.push_back({*view_.position(agent), key});
    if (agent == self_ && key > view_.key(me_)) refute(key, update);
  }
  dissemination_.holds(k, stamp, status.whole, holdings);
}

void Agent::handle(const RoutePublished& route, Update&) {
  if (phase_ != Phase::agreed || route.view_hash != view_hash_) return;
  phase_ = Phase::routed;
  status_is_news_ = true;
}

std::optional<std::size_t> Agent::accept(const Header& header, Update& update) {
  update.refused = refusal(header, expected_, view_);
  if (update.refused) return std::nullopt;
  const auto k = view_.position(header.sender);
  spoke_ns_[*k] = now_ns_;
  return k;
}

void Agent::learn(const Statement& statement, Update& update) {
  update.refused = refusal(statement, expected_, view_);
  if (update.refused) return;
  const std::size_t member = *view_.position(statement.agent);
  if (member == me_) {
    if (statement.key > view_.key(me_)) refute(statement.key, update);
    return;
  }
  if (statement.key <= view_.key(member)) return;  // known already, true or false
  update.refused = audit_.refusal(statement);
  if (update.refused) return;
  const bool was_dead = view_.dead(member);
  view_.merge(statement);
  if (view_.dead(member) && !was_dead) update.died.push_back(statement.agent);
  if (was_dead && !view_.dead(member)) {
    update.returned.push_back(statement.agent);
    membership_.heard(member, {statement.key.incarnation, 0}, now_ns_);
  }
  view_changed(member, update);
}

void Agent::view_changed(std::size_t member, Update& update) {
  dissemination_.learnt(member, now_ns_);
  readiness_.view_changed();
  undecided_ = true;
  status_is_news_ = true;
  if (phase_ == Phase::agreed || phase_ == Phase::routed) {
    phase_ = Phase::auction;
    update.agreement_lost = true;
  }
}

/// Somebody holds something in this agent's name that it did not say in this life: an old life, or
/// a tombstone. It begins a new life above that, once a tick at most: two processes of one id would
/// outdo each other as fast as the network, and what is still held is heard of again.
void Agent::refute(const StatementKey& claimed, Update& update) {
  if (refuted_ns_ && now_ns_ - *refuted_ns_ < mission_->auction.tick_ns) return;
  refuted_ns_ = now_ns_;
  incarnation_ = std::max(claimed.incarnation + 1, incarnation_);
  if (!view_.heard(me_)) return;  // nothing stated yet: the first statement will say it
  state(1);
  view_changed(me_, update);
}

bool Agent::everybody_is_here() const {
  if (matched_peers_ + 1 < view_.roster().size()) return false;
  for (std::size_t k = 0; k < present_.size(); ++k)
    if (k != me_ && !present_[k]) return false;
  return true;
}

void Agent::start_if_everybody_is_here(Update& update) {
  const bool waited = now_ns_ - born_ns_ >= mission_->auction.barrier_ns;
  if (!auction_is_on_ && !waited && !everybody_is_here()) return;
  phase_ = Phase::auction;
  update.started = true;
  status_is_news_ = true;
  // Whoever has never been heard at the end of the barrier is late already.
  if (!waited) membership_.restart_leases(now_ns_);
  state(1);
  if (is_prepared_) decided(true, update);  // the first statement is that decision
}

void Agent::bury_the_silent(Update& update) {
  for (std::size_t k = 0; k < view_.roster().size(); ++k) {
    if (!membership_.silent(k, now_ns_, mission_->auction.lease_ns)) continue;
    dissemination_.forget(k);
    if (view_.dead(k)) continue;
    StatementKey tombstone = view_.key(k);
    tombstone.dead = true;
    view_.merge({view_.roster()[k], tombstone, Claims{}});
    update.died.push_back(view_.roster()[k]);
    view_changed(k, update);
  }
}

void Agent::state(std::uint32_t version) {
  view_.merge({self_, {incarnation_, false, version}, policy_->statement()});
  dissemination_.learnt(me_, now_ns_);
}

/// Rounds go as fast as the network: the next one is due when everybody within direct reach has
/// spoken since the last one, as all do after they have decided, or is known to hold all that is
/// held here, and so has nothing to say. Where somebody is not heard, a tick ends the round.
bool Agent::round_is_over() const {
  const AuctionSettings& auction = mission_->auction;
  if (now_ns_ - decided_ns_ >= auction.tick_ns) return true;
  bool anybody = false;
  for (std::size_t k = 0; k < spoke_ns_.size(); ++k) {
    const bool in_reach = spoke_ns_[k] && now_ns_ - *spoke_ns_[k] <= auction.lease_ns;
    if (!in_reach || view_.dead(k)) continue;
    if (*spoke_ns_[k] <= decided_ns_ && !dissemination_.is_up_to_date(k, view_)) return false;
    anybody = true;
  }
  return anybody;
}

void Agent::decide(Update& update) {
  const Decision decision = policy_->decide(view_);
  undecided_ = !decision.settled;
  if (decision.changed) {
    state(view_.key(me_).version + 1);
    readiness_.view_changed();
  }
  view_hash_ = view_.hash();
  if (decision.settled) readiness_.decided(view_hash_);
  status_is_news_ = true;
  decided(decision.changed, update);
}

/// A round began with what was decided and is now stated.
void Agent::decided(bool changed, Update& update) {
  decided_ns_ = now_ns_;
  round_was_told_ = false;
  update.decision =
      DecisionMade{++round_, changed, view_.key(me_), policy_->statement(), policy_->path()};
}

}  // namespace arcbid
