// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/world/checkers/statements.hpp"

#include <algorithm>

namespace arcbid {
namespace {

/// Timestamps of a table tell what an agent has heard, not what it says: they may go on unsaid.
bool same_content(const StatementBody& a, const StatementBody& b) {
  const auto *left = std::get_if<Table>(&a), *right = std::get_if<Table>(&b);
  return left && right ? left->beliefs == right->beliefs : a == b;
}

}  // namespace

void StatementChecker::note_bids(AgentId agent, const StatementBody& body) {
  auto& bids = bids_.try_emplace(agent, tasks_).first->second;
  const auto note = [&bids](std::size_t task, double bid) {
    std::vector<double>& known = bids.at(task);
    if (std::find(known.begin(), known.end(), bid) == known.end()) known.push_back(bid);
  };
  if (const auto* claims = std::get_if<Claims>(&body))
    for (const Claim& claim : claims->bundle) note(claim.task.value, claim.bid);
  else if (const auto* table = std::get_if<Table>(&body))
    for (std::size_t j = 0; j < table->beliefs.size(); ++j)
      if (table->beliefs[j].winner == agent) note(j, table->beliefs[j].bid);
}

void StatementChecker::check_key(const SeenStep& step, const StatementKey& key,
                                 const StatementBody& body) {
  const auto [at, is_first] = last_.try_emplace(step.life, Said{key, body});
  if (is_first) return;
  Said& last = at->second;
  const bool same = same_content(last.body, body);
  if (key < last.key)
    findings_.add(step.now_ns, "statements", "agent {} goes back from version {} to {}",
                  step.agent.value, last.key.version, key.version);
  else if (key == last.key && !same)
    findings_.add(step.now_ns, "statements", "agent {} states two things as version {}",
                  step.agent.value, key.version);
  if (key != last.key || !same) last = {key, body};
}

bool StatementChecker::was_bid(const Belief& belief, std::size_t task) const {
  const auto bids = bids_.find(*belief.winner);
  if (bids == bids_.end()) return false;
  const std::vector<double>& known = bids->second.at(task);
  return std::find(known.begin(), known.end(), belief.bid) != known.end();
}

void StatementChecker::after(const SeenStep& step) {
  if (const auto& decision = step.update.decision) {
    check_key(step, decision->key, decision->body);
    note_bids(step.agent, decision->body);
  }
  for (const BidMessage& bid : step.update.bids) {
    if (bid.statement.agent != step.agent)
      findings_.add(step.now_ns, "statements", "agent {} bids in the name of {}", step.agent.value,
                    bid.statement.agent.value);
    check_key(step, bid.statement.key, bid.statement.body);
    note_bids(step.agent, bid.statement.body);
  }
  if (!step.winners) return;
  for (std::size_t j = 0; j < step.winners->size(); ++j) {
    const Belief& belief = (*step.winners)[j];
    if (belief.winner && !was_bid(belief, j))
      findings_.add(step.now_ns, "winning-bids", "agent {} believes that {} bid {} for task {}",
                    step.agent.value, belief.winner->value, belief.bid, j);
  }
}

}  // namespace arcbid
