// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a world is over, and what came of it.
#include <algorithm>
#include <map>

#include "core/base/error.hpp"
#include "sim/world/world.hpp"

namespace arcbid {
namespace {

// docs/SIMULATOR.md, "The bound".
constexpr std::size_t hop_ticks = 17;  // patience of a relay, its spread, and the next decision
constexpr TimeNs least_round_ns = 1'000'000;
constexpr std::uint64_t copies = 3;      // of a message: doubled, or stale
constexpr std::size_t extra_rounds = 3;  // a refutation there, its answer back, and the proof

}  // namespace

std::vector<Component> World::living_components() const {
  std::vector<std::size_t> living;
  for (const Life& life : lives_) living.push_back(life.agent);
  std::sort(living.begin(), living.end());
  living.erase(std::unique(living.begin(), living.end()), living.end());
  return components(living,
                    [this](std::size_t a, std::size_t b) { return network_.has_link(a, b); });
}

const World::Life& World::life_of(std::size_t agent) const {
  const auto at = std::find_if(lives_.begin(), lives_.end(),
                               [agent](const Life& life) { return life.agent == agent; });
  check(at != lives_.end(), "the agent lives");
  return *at;
}

/// Everybody in reach of each other proves the same, for exactly themselves, and no fault is to
/// come.
bool World::has_agreed() {
  if (!may_have_agreed_) return false;
  // A fault that has been for a while may still be felt by those who did not notice it yet.
  if (acts_done_ < script_.size() || now_ns_ < last_turn_ns_) return false;
  may_have_agreed_ = false;
  for (const Life& life : lives_)
    if (!life.proof) return false;
  for (const Component& component : living_components()) {
    std::vector<AgentId> members;
    for (const std::size_t k : component.members) members.push_back(spec_.mission.fleet[k].id);
    for (const std::size_t k : component.members) {
      const Agreement& proof = *life_of(k).proof;
      if (proof.members != members) return false;
      if (proof.view_hash != life_of(component.members[0]).proof->view_hash) return false;
    }
  }
  result_.agreed = true;
  return true;
}

TimeNs World::deadline_ns() const {
  if (acts_done_ < script_.size()) return INT64_MAX;
  return std::max(calm_ns_, network_.last_arrival_ns()) + bound_ns_;
}

/// Of the fleet as it is.
TimeNs World::bound_ns() const {
  std::size_t diameter = 1;
  for (const Component& component : living_components())
    diameter = std::max(diameter, component.diameter);
  return bound_ns(diameter);
}

TimeNs World::bound_ns(std::size_t diameter) const {
  const AuctionSettings& auction = spec_.mission.auction;
  const std::size_t tasks = pieces_.size();
  const std::size_t most = auction.bundle_limit > 0 ? lives_.size() * auction.bundle_limit : tasks;
  const auto rounds = static_cast<TimeNs>(diameter * (std::min(tasks, most) + extra_rounds));
  return auction.barrier_ns + auction.lease_ns * static_cast<TimeNs>(8 + diameter) / 4 +
         static_cast<TimeNs>(hop_ticks) * rounds * auction.tick_ns;
}

/// A core that says endlessly much at one moment would keep its world from its end. No sound one
/// gets here: in every tick of the longest world each life wakes once and says a bid, a status and
/// a relay for everybody else, and all of it reaches everybody in three copies.
std::uint64_t World::most_steps() const {
  const std::uint64_t lives = script_.size();  // every life has an act: its start
  // A round ends with a tick, or sooner: when everybody's message is there.
  const TimeNs soonest_ns = std::min(spec_.mission.auction.tick_ns, spec_.latency_ns.least);
  const TimeNs round_ns = std::max<TimeNs>(soonest_ns, least_round_ns);
  const TimeNs longest_ns = std::max(calm_ns_, network_.last_arrival_ns()) + bound_ns(lives);
  const auto rounds = static_cast<std::uint64_t>(longest_ns / round_ns) + 1;
  return rounds * lives * (1 + copies * (lives + 2) * lives);
}

std::vector<Bidder> World::bidders(const Component& component) const {
  std::vector<Bidder> bidders;
  for (const std::size_t k : component.members) {
    const Life& life = life_of(k);
    bidders.push_back({spec_.mission.fleet[k], life.bundle, life.proof->path});
  }
  return bidders;
}

/// What member `n` of a component flies: what it won, or what it has after exchanges. Returns how
/// long that takes, seconds.
double World::fly(const Component& component, std::size_t n, const Bidder& bidder,
                  std::vector<Piece>& flown) {
  const Life& life = life_of(component.members[0]);
  const auto share = exchanged_.find(life.proof->view_hash);
  const bool is_exchanged = share != exchanged_.end() && share->second.is_better();
  const std::vector<PathStop>& path = is_exchanged ? share->second.paths[n] : bidder.path;
  std::vector<TaskId> tasks;
  for (const PathStop& stop : path) tasks.push_back(stop.task);
  for (const Piece& piece : combine(life.core->tasks(), tasks)) flown.push_back(piece);
  const double closed_s = closed_path_s(pieces_, bidder.uav, path, *transit_);
  result_.makespan_s = std::max(result_.makespan_s, closed_s);
  result_.total_length_m += closed_s * bidder.uav.speed_mps;
  return closed_s;
}

void World::check_outcome(const std::vector<Component>& components) {
  const AuctionSettings& auction = spec_.mission.auction;
  const bool is_greedy = spec_.compares_with_greedy && auction.policy == PolicyKind::claims &&
                         auction.score != ScoreKind::discounted_insert;
  std::size_t largest = 0;
  for (const Component& component : components) {
    const std::vector<Bidder> all = bidders(component);
    std::vector<Piece> flown;
    double won_s = 0, flown_s = 0;
    for (std::size_t n = 0; n < all.size(); ++n) {
      flown_s = std::max(flown_s, fly(component, n, all[n], flown));
      won_s = std::max(won_s, closed_path_s(pieces_, all[n].uav, all[n].path, *transit_));
    }
    exchange_checker_.compare(now_ns_, won_s, flown_s);
    const std::vector<Belief>& winners = life_of(component.members[0]).proof->winners;
    if (component.members.size() > largest) {
      largest = component.members.size();
      result_.winners = winners;
    }
    for (std::size_t j = 0; j < winners.size(); ++j)
      if (!winners[j].winner)
        flown.push_back({{pieces_[j].arc}, pieces_[j].from_m, pieces_[j].to_m});
    check_cover(spec_.mission, flown, now_ns_, checkers_.findings);
    if (is_greedy)
      check_greedy(spec_.mission, pieces_, all, *transit_, now_ns_, checkers_.findings);
  }
}

void World::tell_that_it_does_not_end() {
  if (result_.steps >= result_.most_steps)
    checkers_.findings.add(now_ns_, "liveness",
                           "no end after {} steps, the most that this world may take",
                           result_.most_steps);
  else
    checkers_.findings.add(now_ns_, "liveness", "no agreement within {} ms of the calm",
                           result_.bound_ns / 1'000'000);
}

WorldResult World::result() {
  const std::vector<Component> components = living_components();
  if (observer_)
    for (const Life& life : lives_) observer_->outlived(life.number, now_ns_);
  result_.seed = spec_.seed;
  result_.messages = network_.messages();
  result_.bytes = network_.bytes();
  result_.agreed_ns = now_ns_;
  result_.calm_ns = std::max(calm_ns_, network_.last_arrival_ns());
  result_.bound_ns = bound_ns_;
  for (const Life& life : lives_)
    if (life.proof) result_.rounds = std::max(result_.rounds, life.proof->round);
  result_.most_steps = most_steps();
  if (result_.agreed)
    check_outcome(components);
  else if (checkers_.findings.found().empty())
    tell_that_it_does_not_end();
  result_.digest = digest_.add(result_.messages).add(result_.bytes).value();
  result_.violations = checkers_.findings.found();
  for (const Violation& v : result_.violations)
    trace("VIOLATION of {} at {:.3f} ms: {}", v.checker, static_cast<double>(v.now_ns) * 1e-6,
          v.what);
  return result_;
}

}  // namespace arcbid
