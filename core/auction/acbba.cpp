// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/auction/acbba.hpp"

#include <algorithm>

namespace arcbid {
namespace {

constexpr AcbbaReaction leave{AcbbaAction::leave, Rebroadcast::nothing};
constexpr AcbbaReaction leave_say_own{AcbbaAction::leave, Rebroadcast::own};
constexpr AcbbaReaction leave_say_empty{AcbbaAction::leave, Rebroadcast::empty};
constexpr AcbbaReaction update{AcbbaAction::update, Rebroadcast::theirs};
constexpr AcbbaReaction reset{AcbbaAction::reset, Rebroadcast::empty};
constexpr AcbbaReaction refresh{AcbbaAction::refresh, Rebroadcast::own};

AcbbaReaction sender_names_itself(Who receiver, bool higher, int age) {
  if (receiver == Who::i) return higher ? update : refresh;
  if (receiver == Who::k) return age > 0 ? update : leave;
  if (receiver == Who::none) return update;
  return higher || age > 0 ? update : leave_say_own;
}

AcbbaReaction sender_names_receiver(Who receiver) {
  if (receiver == Who::i) return leave;
  if (receiver == Who::k) return reset;
  return receiver == Who::none ? leave_say_empty : leave_say_own;
}

AcbbaReaction sender_names_another(Who receiver, bool higher, int age) {
  if (receiver == Who::i) return higher ? update : refresh;
  if (receiver == Who::k) return update;
  if (receiver == Who::none) return age > 0 ? update : leave;
  if (receiver == Who::m) return age > 0 ? update : age == 0 ? leave : leave_say_own;
  if (higher) return age >= 0 ? update : leave_say_own;
  return age > 0 ? update : leave_say_own;
}

AcbbaReaction sender_names_nobody(Who receiver, int age) {
  if (receiver == Who::i) return leave_say_own;
  if (receiver == Who::k) return update;
  return receiver != Who::none && age > 0 ? update : leave;
}

}  // namespace

AcbbaReaction acbba_rule(Who sender, Who receiver, bool higher, int age) {
  switch (sender) {
    case Who::k:
      return sender_names_itself(receiver, higher, age);
    case Who::i:
      return sender_names_receiver(receiver);
    case Who::none:
      return sender_names_nobody(receiver, age);
    case Who::m:
    case Who::n:
      break;
  }
  return sender_names_another(receiver, higher, age);
}

AcbbaState::AcbbaState(AgentId self, Bundle bundle, std::size_t tasks)
    : self_(self), bundle_(std::move(bundle)) {
  table_.beliefs.resize(tasks);
  table_.timestamps.resize(tasks);
}

void AcbbaState::set(TaskId j, const Belief& belief, std::uint64_t time) {
  table_.beliefs[j.value] = belief;
  table_.timestamps[j.value] = time;
}

Rebroadcast AcbbaState::receive(AgentId sender, TaskId j, const TimedBelief& theirs) {
  clock_ = std::max(clock_, theirs.time);
  const TimedBelief ours = belief(j);
  const auto [sends, has] = believed(self_, sender, theirs.belief.winner, ours.belief.winner);
  const bool higher =
      theirs.belief.winner && beats(theirs.belief.bid, *theirs.belief.winner, ours.belief);
  const int age = (theirs.time > ours.time) - (theirs.time < ours.time);
  const AcbbaReaction reaction = acbba_rule(sends, has, higher, age);
  if (reaction.action == AcbbaAction::update) set(j, theirs.belief, theirs.time);
  if (reaction.action == AcbbaAction::reset) set(j, {}, ++clock_);
  if (reaction.action == AcbbaAction::refresh) set(j, ours.belief, ++clock_);
  return reaction.say;
}

void AcbbaState::forget(AgentId dead) {
  for (std::uint32_t j = 0; j < table_.beliefs.size(); ++j)
    if (table_.beliefs[j].winner == dead) set({j}, {}, ++clock_);
}

std::vector<TaskId> AcbbaState::rebid() {
  const std::vector<Claim>& claims = bundle_.claims();
  std::vector<TaskId> changed;
  std::size_t kept = 0;
  while (kept < claims.size() && table_.beliefs[claims[kept].task.value].winner == self_) ++kept;
  for (std::size_t n = kept; n < claims.size(); ++n) {
    if (table_.beliefs[claims[n].task.value].winner != self_) continue;
    set(claims[n].task, {}, ++clock_);
    changed.push_back(claims[n].task);
  }
  bundle_.release_from(kept);
  bundle_.extend(table_.beliefs);
  for (std::size_t n = kept; n < claims.size(); ++n) {
    set(claims[n].task, {self_, claims[n].bid}, ++clock_);
    changed.push_back(claims[n].task);
  }
  std::sort(changed.begin(), changed.end());
  changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
  return changed;
}

bool AcbbaPolicy::agrees(const View& view) const {
  for (std::size_t k = 0; k < view.roster().size(); ++k) {
    const auto* table = std::get_if<Table>(&view.of(k).body);
    if (!view.dead(k) && table && table->beliefs != state_.table().beliefs) return false;
  }
  return true;
}

Decision AcbbaPolicy::decide(const View& view) {
  applied_.resize(view.roster().size());
  const Table before = state_.table();
  for (std::size_t k = 0; k < view.roster().size(); ++k)
    if (view.dead(k)) state_.forget(view.roster()[k]);
  for (std::size_t k = 0; k < view.roster().size(); ++k) {
    const AgentId sender = view.roster()[k];
    const auto* table = std::get_if<Table>(&view.of(k).body);
    const bool news = applied_[k] < view.key(k);
    applied_[k] = view.key(k);
    if (!table || view.dead(k) || !news || sender == state_.self()) continue;
    for (std::uint32_t j = 0; j < table->beliefs.size(); ++j) {
      Belief belief = table->beliefs[j];
      if (belief.winner && view.dead(*belief.winner)) belief = {};
      state_.receive(sender, {j}, {belief, table->timestamps[j]});
    }
  }
  state_.rebid();
  // Nothing new is left to apply: deciding again on the same view changes nothing.
  return {.changed = state_.table() != before, .settled = true};
}

}  // namespace arcbid
