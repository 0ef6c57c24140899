// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/replay/mind.hpp"

#include <algorithm>

#include "core/auction/bundle.hpp"
#include "core/auction/roster.hpp"

namespace arcbid {
namespace {

/// A table does not say in which order tasks were taken; bids never rise along a bundle.
std::vector<Claim> bundle_of(const StatementBody& body, AgentId self) {
  if (const auto* claims = std::get_if<Claims>(&body)) return claims->bundle;
  std::vector<Claim> out;
  const std::vector<Belief>& beliefs = std::get<Table>(body).beliefs;
  for (std::uint32_t j = 0; j < beliefs.size(); ++j)
    if (beliefs[j].winner == self) out.push_back({{j}, beliefs[j].bid});
  std::stable_sort(out.begin(), out.end(),
                   [](const Claim& a, const Claim& b) { return a.bid > b.bid; });
  return out;
}

}  // namespace

Mind::Mind(const RunArchive& run, const RunIndex& index, std::size_t life)
    : run_(run),
      index_(index),
      log_(run.lives[life]),
      roster_(roster_of(*run.mission)),
      self_(position(log_.agent())),
      heard_(roster_.size(), 0),
      heard_last_(heard_),
      rivals_(run.tasks.tasks.size()),
      rivals_before_(rivals_) {}

std::size_t Mind::position(AgentId agent) const {
  return position_in(roster_, agent).value();
}

const Learnt* Mind::held(std::size_t member, const Cursors& heard) const {
  return heard[member] == 0 ? nullptr : &log_.learnt()[member][heard[member] - 1];
}

Mind::Cursors Mind::heard_before(Cursors heard, std::size_t end) const {
  for (std::size_t k = 0; k < roster_.size(); ++k) {
    const auto& learnt = log_.learnt()[k];
    while (heard[k] < learnt.size() && learnt[heard[k]].mark < end) ++heard[k];
  }
  return heard;
}

void Mind::decide(const RunIndex::Decision& decision) {
  const StatementBody* stated = index_.body(log_.agent(), decision.key);
  heard_last_ = heard_;
  heard_ = heard_before(heard_, decision.mark + 1);
  before_ = std::move(after_);
  after_ = stated ? bundle_of(*stated, log_.agent()) : std::vector<Claim>();
  rivals_before_ = std::move(rivals_);
  const auto* table = stated ? std::get_if<Table>(stated) : nullptr;
  if (table) {
    const Table none{std::vector<Belief>(table->beliefs.size()),
                     std::vector<std::uint64_t>(table->timestamps.size())};
    take_table(own_ ? std::get<Table>(*own_) : none, *table);
  } else {
    rivals_ = best_of_others(heard_);
  }
  own_ = stated;
}

std::vector<Belief> Mind::best_of_others(const Cursors& heard) const {
  std::vector<Belief> best(run_.tasks.tasks.size());
  for (std::size_t k = 0; k < roster_.size(); ++k) {
    const Learnt* of = k == self_ ? nullptr : held(k, heard);
    const StatementBody* body = of ? index_.body(roster_[k], of->key) : nullptr;
    const auto* claims = body ? std::get_if<Claims>(body) : nullptr;
    if (!claims) continue;
    for (const Claim& claim : claims->bundle)
      if (beats(claim.bid, roster_[k], best[claim.task.value]))
        best[claim.task.value] = {roster_[k], claim.bid};
  }
  return best;
}

void Mind::take_table(const Table& before, const Table& after) {
  table_losses_ =
      table_losses(run_.mission->auction.policy, roster_, log_.agent(), before, tables());
  rivals_.assign(after.beliefs.size(), {});
  for (std::size_t j = 0; j < rivals_.size(); ++j)
    for (const Table* table : {&after, &before})
      if (!rivals_[j].winner && table->beliefs[j].winner != log_.agent())
        rivals_[j] = table->beliefs[j];
}

std::vector<HeldTable> Mind::tables() const {
  std::vector<HeldTable> out(roster_.size());
  for (std::size_t k = 0; k < roster_.size(); ++k) {
    const Learnt* of = held(k, heard_);
    if (!of) continue;
    const StatementBody* body = index_.body(roster_[k], of->key);
    out[k] = {of->key, body ? std::get_if<Table>(body) : nullptr, heard_[k] > heard_last_[k]};
  }
  return out;
}

std::optional<Mind::Loss> Mind::loss(const Claim& claim) const {
  for (const TableLoss& lost : table_losses_)
    if (lost.task == claim.task) {
      const Learnt* from = held(lost.sender, heard_);
      return Loss{lost.winner, from ? std::optional(from->mark) : std::nullopt, lost.row,
                  lost.rule};
    }
  const Belief& rival = rivals_[claim.task.value];
  if (own_ && std::holds_alternative<Table>(*own_)) return std::nullopt;
  if (!rival.winner || !beats(rival.bid, *rival.winner, {log_.agent(), claim.bid}))
    return std::nullopt;
  return Loss{rival, first_to_beat(position(*rival.winner), claim), 0,
              rival.bid == claim.bid ? "equal bids: lower id" : "eq. (5): higher bid wins"};
}

/// The first statement heard since the decision before that outbids the claim.
std::optional<std::size_t> Mind::first_to_beat(std::size_t member, const Claim& claim) const {
  const auto& learnt = log_.learnt()[member];
  for (std::size_t n = heard_last_[member]; n < heard_[member]; ++n) {
    const StatementBody* body = index_.body(roster_[member], learnt[n].key);
    const auto* claims = body ? std::get_if<Claims>(body) : nullptr;
    if (!claims) continue;
    for (const Claim& theirs : claims->bundle)
      if (theirs.task == claim.task &&
          beats(theirs.bid, roster_[member], {log_.agent(), claim.bid}))
        return learnt[n].mark;
  }
  return std::nullopt;
}

const Learnt* Mind::news_of(AgentId agent) const {
  const std::size_t k = position(agent);
  return heard_[k] > heard_last_[k] ? held(k, heard_) : nullptr;
}

std::vector<TaskId> Mind::tasks_of(AgentId agent, std::size_t mark) const {
  std::vector<TaskId> out;
  const auto* own = own_ ? std::get_if<Table>(own_) : nullptr;
  const std::vector<Belief> known = own ? own->beliefs : best_of_others(heard_before(heard_, mark));
  for (std::uint32_t j = 0; j < known.size(); ++j) {
    const auto mine = std::find_if(after_.begin(), after_.end(),
                                   [j](const Claim& claim) { return claim.task == TaskId{j}; });
    const bool is_mine = !own && mine != after_.end() && beats(mine->bid, log_.agent(), known[j]);
    if (known[j].winner == agent && !is_mine) out.push_back({j});
  }
  return out;
}

bool Mind::buried(AgentId agent, std::uint64_t incarnation) const {
  const auto& learnt = log_.learnt()[position(agent)];
  return !learnt.empty() && learnt.back().key.dead && learnt.back().key.incarnation >= incarnation;
}

}  // namespace arcbid
