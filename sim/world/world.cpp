// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/world/world.hpp"

#include <algorithm>

#include "core/route/make_transit.hpp"

namespace arcbid {
namespace {

constexpr TimeNs least_wait_ns = 100'000;

std::vector<StatementKey> keys_of_others(const View& view, std::size_t self) {
  std::vector<StatementKey> keys = view.keys();
  keys[self] = {};
  return keys;
}

/// What is not newer than what is held is passed over, true or false.
bool is_old_news(const Event& event, const View& view, const std::vector<StatementKey>& held) {
  const auto* bid = std::get_if<BidMessage>(&event.what);
  const auto author = bid ? view.position(bid->statement.agent) : std::nullopt;
  return author && bid->statement.key <= held[*author];
}

}  // namespace

World::World(const WorldSpec& spec, const Trace& trace, WorldObserver* observer)
    : spec_(spec),
      trace_(trace),
      observer_(observer),
      mission_(std::make_shared<const Mission>(spec.mission)),
      transit_(spec.transit ? spec.transit : make_transit(spec.mission)),
      pieces_(cut(spec.mission)),
      network_(spec),
      script_(script_of(spec)),
      has_clock_fault_(spec.mission.fleet.size(), false),
      checkers_(spec.mission, pieces_, *transit_),
      exchange_checker_(spec.mission, pieces_, *transit_, checkers_.findings),
      calm_ns_(arcbid::calm_ns(spec)),
      last_turn_ns_(arcbid::last_turn_ns(spec.faults)) {
  for (std::size_t k = 0; k < has_clock_fault_.size(); ++k)
    for (const AgentFault& fault : spec.faults.agents) {
      const AgentId id = spec.mission.fleet[k].id;
      if (fault.agent != id) continue;
      if (fault.kind == AgentFaultKind::clock) has_clock_fault_[k] = true;
      if (fault.kind == AgentFaultKind::twin) checkers_.stability.has_twin(id);
    }
  if (observer_)
    network_.watch([this](const Delivery& message, const Fate& fate) { tell_fate(message, fate); });
}

WorldResult World::run() {
  trace("{}", summary(spec_));
  while (checkers_.findings.found().empty() && next()) continue;
  return result();
}

/// The earliest of: an act of the script, a message's arrival, an agent's wish to be woken. Of one
/// time, in this order: a tick comes when all that has arrived was heard.
bool World::next() {
  if (has_agreed() || now_ns_ > deadline_ns() || result_.steps >= most_steps()) return false;
  const TimeNs act_ns = acts_done_ < script_.size() ? script_[acts_done_].at_ns : INT64_MAX;
  const TimeNs arrival_ns = network_.empty() ? INT64_MAX : network_.next_ns();
  Life* const sleeper = first_to_wake();
  const TimeNs wake_ns = sleeper ? sleeper->wake_ns : INT64_MAX;
  const TimeNs next_ns = std::min({act_ns, arrival_ns, wake_ns});
  if (next_ns == INT64_MAX) return false;
  now_ns_ = std::max(now_ns_, next_ns);
  if (act_ns == next_ns) {
    act(script_[acts_done_++]);
    bound_ns_ = bound_ns();
  } else if (arrival_ns == next_ns) {
    deliver(network_.pop());
  } else {
    wake(*sleeper);
  }
  return true;
}

World::Life* World::first_to_wake() {
  Life* first = nullptr;
  for (Life& life : lives_)
    if (!life.is_paused && (!first || life.wake_ns < first->wake_ns)) first = &life;
  return first;
}

TimeNs World::clock_ns(std::size_t agent) const {
  if (!has_clock_fault_[agent]) return now_ns_;
  return clock_of(spec_.faults, spec_.mission.fleet[agent].id, now_ns_);
}

std::uint32_t World::matched_peers(const Life& life) const {
  std::vector<bool> present(spec_.mission.fleet.size(), false);
  for (const Life& other : lives_) present[other.agent] = true;
  present[life.agent] = false;
  return static_cast<std::uint32_t>(std::count(present.begin(), present.end(), true));
}

void World::wake(Life& life) {
  if (life.said) {
    for (Spoiling& spoiling : life.spoilings) say_something_bad(life, spoiling);
    std::erase_if(life.spoilings, [](const Spoiling& spoiling) { return spoiling.left == 0; });
  }
  if (!life.is_routed) {
    life.is_routed = true;
    step(life, {clock_ns(life.agent), RoutePublished{life.proof->view_hash}});
  }
  step(life, {clock_ns(life.agent), Tick{matched_peers(life)}});
  life.wake_ns = std::max(life.wake_ns, now_ns_ + 1);
}

void World::deliver(const Delivery& delivery) {
  for (Life& life : lives_) {
    if (life.agent != delivery.to || life.number == delivery.from_life) continue;
    if (life.is_paused)
      life.inbox.push_back(delivery);
    else
      hear(life, delivery);
  }
}

void World::tell_fate(const Delivery& message, const Fate& fate) const {
  const Header* header = nullptr;
  std::visit(
      [&header](const auto& what) {
        if constexpr (requires { what.header; }) header = &what.header;
      },
      message.event->what);
  const bool is_untouched = fate.arrivals_ns.size() == 1 && fate.arrivals_ns.front() == now_ns_;
  if (is_untouched || !header) return;
  for (const Life& life : lives_)
    if (life.agent == message.to) observer_->met_fate(life.number, now_ns_, *header, fate);
}

void World::hear(Life& life, const Delivery& delivery) {
  delivery.event->now_ns = clock_ns(life.agent);
  const View& view = life.core->view();
  const auto before =
      delivery.is_malformed ? keys_of_others(view, life.agent) : std::vector<StatementKey>{};
  Update update = life.core->step(*delivery.event);
  if (observer_) observer_->stepped(life.number, now_ns_, *delivery.event, update);
  check_refusal(life, delivery, update, before);
  carry_out(life, update);
}

void World::check_refusal(const Life& life, const Delivery& delivery, const Update& update,
                          const std::vector<StatementKey>& before) {
  const AgentId agent = spec_.mission.fleet[life.agent].id;
  const bool of_its_twin = delivery.from == life.agent;
  if (update.refused) ++result_.refused;
  if (update.refused && !delivery.is_malformed && !of_its_twin)
    checkers_.findings.add(now_ns_, "refusal", "agent {} refuses a sound message: {}", agent.value,
                           *update.refused);
  if (!delivery.is_malformed) return;
  if (!update.refused && !is_old_news(*delivery.event, life.core->view(), before))
    checkers_.findings.add(now_ns_, "refusal", "agent {} takes a malformed message", agent.value);
  if (keys_of_others(life.core->view(), life.agent) != before)
    checkers_.findings.add(now_ns_, "refusal", "agent {} learns from a malformed message",
                           agent.value);
}

void World::step(Life& life, const Event& event) {
  Update update = life.core->step(event);
  if (observer_) observer_->stepped(life.number, now_ns_, event, update);
  carry_out(life, update);
}

void World::carry_out(Life& life, Update& update) {
  const AgentId agent = spec_.mission.fleet[life.agent].id;
  std::vector<Belief> winners;
  if (update.decision) winners = life.core->winners();
  checkers_.after({now_ns_, agent, life.number, update, life.core->view(),
                   update.decision ? &winners : nullptr});
  remember(life, update);
  for (const BidMessage& bid : update.bids) {
    network_.broadcast(life.agent, life.number, bid, now_ns_);
    life.said = bid;
    if (life.history.size() < 4) life.history.push_back(bid);
  }
  for (const RelayMessage& relay : update.relays)
    network_.broadcast(life.agent, life.number, relay, now_ns_);
  for (const StatusMessage& status : update.statuses)
    network_.broadcast(life.agent, life.number, status, now_ns_);
  const TimeNs wait_ns = update.wake_ns - clock_ns(life.agent);
  // A clock that runs or jumps: the agent is asked again soon.
  life.wake_ns = now_ns_ + (has_clock_fault_[life.agent]
                                ? std::clamp(wait_ns, least_wait_ns, mission_->auction.tick_ns)
                                : std::max<TimeNs>(wait_ns, 0));
  if (update.decision)
    if (const auto* claims = std::get_if<Claims>(&update.decision->body))
      life.bundle = claims->bundle;
  if (update.agreement_lost) life.proof.reset();
  if (update.agreed) {
    work_out_exchanges(life, *update.agreed);
    life.proof = std::move(update.agreed);
    life.is_routed = false;
    may_have_agreed_ = true;
  }
  if (!life.proof) life.is_routed = true;
}

void World::work_out_exchanges(const Life& life, const Agreement& proof) {
  if (!exchange_checker_.wants(proof)) return;
  FleetShare share = fleet_share(*mission_, life.core->tasks(), proof, *transit_);
  exchange_checker_.after(now_ns_, proof, share);
  digest_.add(share.exchanges);
  for (const auto& path : share.paths)
    for (const PathStop& stop : path)
      digest_.add(std::uint64_t{stop.task.value}).add(std::uint64_t{stop.reversed});
  exchanged_[proof.view_hash] = std::move(share);
}

/// Into the digest, and the trace.
void World::remember(const Life& life, const Update& update) {
  ++result_.steps;
  digest_.add(static_cast<std::uint64_t>(now_ns_)).add(std::uint64_t{life.number});
  digest_.add(static_cast<std::uint64_t>(update.wake_ns));
  digest_.add(std::uint64_t{update.bids.size()}).add(std::uint64_t{update.relays.size()});
  for (const StatusMessage& status : update.statuses)
    digest_.add(status.view_hash).add(std::uint64_t{status.ready.size()});
  if (!trace_) return;
  const std::uint32_t id = spec_.mission.fleet[life.agent].id.value;
  if (update.refused) trace("agent {} refuses: {}", id, *update.refused);
  for (const AgentId other : update.died) trace("agent {} declares {} dead", id, other.value);
  for (const AgentId other : update.returned) trace("agent {} sees {} return", id, other.value);
  if (update.decision && update.decision->changed)
    trace("agent {} decides: version {}.{}, path of {}", id, update.decision->key.incarnation,
          update.decision->key.version, update.decision->path.size());
  if (update.agreement_lost) trace("agent {} loses the agreement", id);
  if (update.agreed)
    trace("agent {} proves {:016x} for {} members", id, update.agreed->view_hash,
          update.agreed->members.size());
}

WorldResult run_world(const WorldSpec& spec, const Trace& trace, WorldObserver* observer) {
  return World(spec, trace, observer).run();
}

}  // namespace arcbid
