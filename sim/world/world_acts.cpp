// SPDX-License-Identifier: GPL-3.0-or-later
// What happens to the processes of a world.
#include <algorithm>
#include <utility>

#include "core/faults/malform.hpp"
#include "sim/world/world.hpp"

namespace arcbid {
namespace {

constexpr std::uint64_t first_birth = 1'000'000'000;  // ms: clocks may be set back by a lot

}  // namespace

void World::act(const Act& act) {
  may_have_agreed_ = true;
  switch (act.kind) {
    case Act::Kind::start:
      return start(act.agent, false);
    case Act::Kind::crash:
      return stop(act.agent, false);
    case Act::Kind::pause:
      trace("agent {} is paused", spec_.mission.fleet[act.agent].id.value);
      for (Life* life : lives_of(act.agent)) life->is_paused = true;
      return;
    case Act::Kind::resume:
      return resume(act.agent);
    case Act::Kind::twin_start:
      return start(act.agent, true);
    case Act::Kind::twin_stop:
      return stop(act.agent, true);
    case Act::Kind::malform:
      for (Life* life : lives_of(act.agent))
        life->spoilings.push_back({act.malformation, act.count});
      return;
    case Act::Kind::over_bid:
      return bid_over(act);
  }
}

void World::start(std::size_t agent, bool is_twin) {
  const AgentId id = spec_.mission.fleet[agent].id;
  const TimeNs clock = clock_ns(agent);
  const auto incarnation =
      static_cast<std::uint64_t>(static_cast<TimeNs>(first_birth) + clock / 1'000'000);
  Life& life = lives_.emplace_back();
  life.agent = agent;
  life.number = births_++;
  life.core = std::make_unique<Agent>(id, incarnation, mission_, transit_, clock);
  if (observer_) observer_->born(life.number, id, incarnation, now_ns_, clock);
  life.wake_ns = now_ns_;
  life.is_twin = is_twin;
  trace("agent {} starts{}, life {}", id.value, is_twin ? " a second time" : "", incarnation);
  if (life.number == 0) {
    const std::vector<Task>& tasks = life.core->tasks().tasks;
    check_split(pieces_, tasks, checkers_.findings);
    take_places(tasks, pieces_);
  }
}

void World::stop(std::size_t agent, bool twins) {
  trace("agent {}{} is gone", spec_.mission.fleet[agent].id.value, twins ? "'s twin" : "");
  std::erase_if(lives_,
                [&](const Life& life) { return life.agent == agent && life.is_twin == twins; });
}

std::vector<World::Life*> World::lives_of(std::size_t agent) {
  std::vector<Life*> found;
  for (Life& life : lives_)
    if (life.agent == agent) found.push_back(&life);
  return found;
}

void World::resume(std::size_t agent) {
  trace("agent {} goes on", spec_.mission.fleet[agent].id.value);
  for (Life* life : lives_of(agent)) {
    life->is_paused = false;
    for (const Delivery& delivery : std::exchange(life->inbox, {})) hear(*life, delivery);
    life->wake_ns = now_ns_;
  }
}

/// It says so as often as it was told to, and is silent from then on: its process is gone.
void World::bid_over(const Act& act) {
  for (Life* life : lives_of(act.agent)) {
    if (!life->said) continue;
    BidMessage bad = over_bid(*life->said, pieces_.size());
    for (std::uint32_t n = 0; n < std::max(act.count, 1U); ++n) {
      ++bad.header.sequence;
      network_.broadcast(life->agent, life->number, bad, now_ns_, true);
    }
  }
  stop(act.agent, false);
}

void World::say_something_bad(Life& life, Spoiling& spoiling) {
  --spoiling.left;
  if (spoiling.how == Malformation::replay) {
    network_.broadcast(life.agent, life.number, life.history[spoiling.left % life.history.size()],
                       now_ns_);
    return;
  }
  network_.broadcast(life.agent, life.number, malformed(*life.said, spoiling.how, pieces_.size()),
                     now_ns_, true);
}

}  // namespace arcbid
