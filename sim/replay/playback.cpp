// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/replay/playback.hpp"

#include <algorithm>

#include "core/auction/roster.hpp"
#include "core/base/error.hpp"

namespace arcbid {
namespace {

std::size_t fleet_position(const Mission& mission, AgentId agent) {
  const auto roster = roster_of(mission);
  return static_cast<std::size_t>(std::lower_bound(roster.begin(), roster.end(), agent) -
                                  roster.begin());
}

constexpr std::uint8_t route_published = 4;  // index of Event::what

}  // namespace

Playback::Playback(const RunArchive& run)
    : run_(run),
      moments_(causal_order(run)),
      turns_(run.mission->fleet.size()),
      when_(run.lives.size()) {
  for (const LifeLog& life : run.lives)
    position_.push_back(fleet_position(*run.mission, life.agent()));
  for (std::size_t m = 0; m < moments_.size(); ++m) note(m);
  // A life is over with its last step: it ended by itself, or was not heard of again.
  for (std::size_t l = 0; l < run.lives.size(); ++l) {
    if (when_[l].empty()) continue;
    auto& turns = turns_[position_[l]];
    if (turns.back().state.life != l) continue;
    AgentState state = turns.back().state;
    state.steps = run.lives[l].marks().size();
    const std::string& by = run.lives[l].ended_by();
    state.state = by == "coordinator" || by == "world" ? State::ended : State::dead;
    turns.push_back({when_[l].back() + 1, state});
  }
}

void Playback::note(std::size_t moment) {
  const auto [life, at, t_ns] = moments_[moment];
  const LifeLog& log = run_.lives[life];
  const Mark& mark = log.marks()[at];
  when_[life].push_back(moment);
  auto& turns = turns_[position_[life]];
  AgentState now = turns.empty() ? AgentState{} : turns.back().state;
  const AgentState before = now;
  if (now.life != life) now = {State::waiting, life, 0, 0};
  if (mark.started || mark.lost) now.state = State::bidding;
  if (mark.agreed) now.state = State::agreed;
  if (mark.event == route_published && now.state == State::agreed) now.state = State::routed;
  now.round = mark.round;
  const bool news = turns.empty() || now.life != before.life || now.state != before.state ||
                    now.round != before.round;
  if (news) turns.push_back({moment, now});
}

std::size_t Playback::at(TimeNs t_ns) const {
  return static_cast<std::size_t>(
      std::upper_bound(moments_.begin(), moments_.end(), t_ns,
                       [](TimeNs t, const Moment& moment) { return t < moment.t_ns; }) -
      moments_.begin());
}

std::vector<Playback::AgentState> Playback::agents(std::size_t moments) const {
  std::vector<AgentState> out;
  for (const auto& turns : turns_) {
    const auto after = std::lower_bound(turns.begin(), turns.end(), moments,
                                        [](const Turn& t, std::size_t m) { return t.moment < m; });
    if (after == turns.begin()) {
      out.emplace_back();
      continue;
    }
    AgentState state = std::prev(after)->state;
    const auto& when = when_[*state.life];
    state.steps = static_cast<std::size_t>(std::lower_bound(when.begin(), when.end(), moments) -
                                           when.begin());
    // The turn to dead lies behind the last step of all.
    if (moments >= moments_.size()) state = turns.back().state;
    out.push_back(state);
  }
  return out;
}

std::optional<Learnt> Playback::newest(std::size_t life, std::size_t member,
                                       std::size_t steps) const {
  const auto& held = run_.lives[life].learnt()[member];
  const auto after = std::lower_bound(held.begin(), held.end(), steps,
                                      [](const Learnt& l, std::size_t s) { return l.mark < s; });
  if (after == held.begin()) return std::nullopt;
  return *std::prev(after);
}

Statement Playback::statement(std::size_t life, std::size_t member, const Learnt& learnt) const {
  Statement said = on_record(life, member, learnt);
  // A record that is damaged may name tasks that there are not.
  if (auto* claims = std::get_if<Claims>(&said.body))
    std::erase_if(claims->bundle, [this](const Claim& claim) {
      return claim.task.value >= run_.tasks.tasks.size();
    });
  return said;
}

Statement Playback::on_record(std::size_t life, std::size_t member, const Learnt& learnt) const {
  const AgentId of = run_.mission->fleet[member].id;
  Statement none{of, learnt.key, Claims{}};
  if (learnt.key.dead) return none;  // a tombstone claims nothing
  const Step step = run_.lives[life].step(learnt.mark);
  if (learnt.is_own) {
    if (step.update.decision && step.update.decision->key == learnt.key)
      return {of, learnt.key, step.update.decision->body};
    for (const BidMessage& bid : step.update.bids)
      if (bid.statement.key == learnt.key) return bid.statement;
  }
  if (const auto* bid = std::get_if<BidMessage>(&step.event.what)) return bid->statement;
  if (const auto* relay = std::get_if<RelayMessage>(&step.event.what)) return relay->statement;
  return none;
}

View Playback::view(std::size_t life, std::size_t steps) const {
  View view(roster_of(*run_.mission));
  for (std::size_t member = 0; member < run_.mission->fleet.size(); ++member)
    if (const auto learnt = newest(life, member, steps))
      view.merge(statement(life, member, *learnt));
  return view;
}

std::vector<Belief> Playback::beliefs(std::size_t life, std::size_t steps) const {
  const std::size_t tasks = run_.tasks.tasks.size();
  if (states_claims(run_.mission->auction.policy)) return best_claims(view(life, steps), tasks);
  const std::size_t self = position_[life];
  const auto own = newest(life, self, steps);
  if (!own) return std::vector<Belief>(tasks);
  const Statement said = statement(life, self, *own);
  const auto* table = std::get_if<Table>(&said.body);
  return table && table->beliefs.size() == tasks ? table->beliefs : std::vector<Belief>(tasks);
}

std::vector<Belief> Playback::owners(std::size_t moments) const {
  const auto states = agents(moments);
  View said(roster_of(*run_.mission));
  for (std::size_t k = 0; k < states.size(); ++k) {
    const AgentState& state = states[k];
    if (!state.life || state.state == State::unborn || state.state == State::dead) continue;
    if (!states_claims(run_.mission->auction.policy)) return beliefs(*state.life, state.steps);
    if (const auto own = newest(*state.life, k, state.steps))
      said.merge(statement(*state.life, k, *own));
  }
  return best_claims(said, run_.tasks.tasks.size());
}

}  // namespace arcbid
