// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/auction/cbba.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

#include "core/auction/roster.hpp"
#include "core/base/error.hpp"

namespace arcbid {
namespace {

constexpr std::size_t block = 16;  // beliefs compared at once

}  // namespace

CbbaState::CbbaState(AgentId self, std::vector<AgentId> roster, Bundle bundle, std::size_t tasks,
                     bool rebuilds)
    : self_(self), roster_(std::move(roster)), bundle_(std::move(bundle)), rebuilds_(rebuilds) {
  table_.beliefs.resize(tasks);
  table_.timestamps.resize(roster_.size());
}

std::uint64_t timestamp_of(const StatementKey& key) {
  return (key.incarnation << 22) | key.version;
}

Fired fired(const std::vector<AgentId>& roster, const Side& sender, const Side& receiver) {
  const Belief &theirs = sender.belief, &ours = receiver.belief;
  const auto [sends, has] = believed(receiver.agent, sender.agent, theirs.winner, ours.winner);
  std::uint8_t holds = always;
  const auto compare = [&](AgentId other, std::uint8_t newer, std::uint8_t same_too,
                           std::uint8_t older) {
    const auto at = position_in(roster, other);
    check(at.has_value(), "a believed winner is of the roster");
    const std::uint64_t s_k = sender.timestamps[*at], s_i = receiver.timestamps[*at];
    if (s_k > s_i) holds |= newer;
    if (s_k >= s_i) holds |= same_too;
    if (s_k < s_i) holds |= older;
  };
  if (sends == Who::m)
    compare(*theirs.winner, newer_m, newer_or_same_m, older_m);
  else if (has == Who::m)
    compare(*ours.winner, newer_m, newer_or_same_m, older_m);
  if (has == Who::n) compare(*ours.winner, newer_n, always, always);
  if (theirs.winner && beats(theirs.bid, *theirs.winner, ours)) holds |= higher_bid;
  const Row& rule = row(sends, has);
  return {rule, decide(rule, holds)};
}

bool CbbaState::apply(AgentId sender, const Table& table, std::size_t first, std::size_t last) {
  bool changed = false;
  for (std::size_t j = first; j < last; ++j) {
    Belief& ours = table_.beliefs[j];
    const Belief& theirs = table.beliefs[j];
    if (theirs == ours) continue;  // no row changes anything then
    const Action action =
        fired(roster_, {sender, theirs, table.timestamps}, {self_, ours, table_.timestamps}).action;
    if (action == Action::leave) continue;
    ours = action == Action::update ? theirs : Belief{};
    changed = true;
  }
  return changed;
}

bool CbbaState::receive(std::size_t sender, const Table& table, std::uint64_t now) {
  bool changed = false;
  const std::size_t tasks = table_.beliefs.size();
  for (std::size_t first = 0; first < tasks; first += block) {
    const std::size_t last = std::min(first + block, tasks);
    // Most beliefs are shared. Equal bytes are equal beliefs (not the other way round: padding).
    const bool same = std::memcmp(&table_.beliefs[first], &table.beliefs[first],
                                  (last - first) * sizeof(Belief)) == 0;
    if (!same) changed |= apply(roster_[sender], table, first, last);
  }
  for (std::size_t m = 0; m < roster_.size(); ++m)
    table_.timestamps[m] = std::max(table_.timestamps[m], table.timestamps[m]);
  table_.timestamps[sender] = now;
  return changed;
}

void CbbaState::forget(AgentId dead) {
  for (Belief& belief : table_.beliefs)
    if (belief.winner == dead) belief = {};
}

void CbbaState::release() {
  const std::vector<Claim>& claims = bundle_.claims();
  std::size_t kept = 0;
  while (kept < claims.size() && table_.beliefs[claims[kept].task.value].winner == self_) ++kept;
  for (std::size_t n = kept; n < claims.size(); ++n) {
    Belief& belief = table_.beliefs[claims[n].task.value];
    if (belief.winner == self_) belief = {};
  }
  bundle_.release_from(kept);
}

bool CbbaState::bid() {
  if (!rebuilds_) {
    bundle_.extend(table_.beliefs);
    return claim();
  }
  for (const Claim& claim : bundle_.claims()) table_.beliefs[claim.task.value] = {};
  const bool changed = bundle_.rebuild(table_.beliefs);
  claim();
  return changed;
}

/// Writes what the bundle claims into z_i and y_i.
bool CbbaState::claim() {
  bool changed = false;
  for (const Claim& claim : bundle_.claims()) {
    const Belief mine{self_, claim.bid};
    Belief& belief = table_.beliefs[claim.task.value];
    changed = changed || belief != mine;
    belief = mine;
  }
  return changed;
}

bool CbbaPolicy::agrees(const View& view) const {
  for (std::size_t k = 0; k < view.roster().size(); ++k) {
    const auto* table = std::get_if<Table>(&view.of(k).body);
    if (!view.dead(k) && table && table->beliefs != state_.table().beliefs) return false;
  }
  return true;
}

Decision CbbaPolicy::decide(const View& view) {
  const std::vector<Belief> before = state_.table().beliefs;
  for (std::size_t k = 0; k < view.roster().size(); ++k)
    if (view.dead(k)) state_.forget(view.roster()[k]);
  for (std::size_t k = 0; k < view.roster().size(); ++k) {
    const auto* table = std::get_if<Table>(&view.of(k).body);
    if (!table || view.dead(k) || state_.is_self(k)) continue;
    Table living = *table;  // its owner may not know yet who died
    for (Belief& belief : living.beliefs)
      if (belief.winner && view.dead(*belief.winner)) belief = {};
    state_.receive(k, living, timestamp_of(view.key(k)));
  }
  state_.release();
  state_.bid();
  const bool changed = state_.table().beliefs != before;
  return {.changed = changed, .settled = !changed};
}

}  // namespace arcbid
