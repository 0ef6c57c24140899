// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/auction/bundle.hpp"

#include <algorithm>
#include <utility>

namespace arcbid {

bool beats(double bid, AgentId bidder, const Belief& rival) {
  if (!rival.winner) return true;
  return bid > rival.bid || (bid == rival.bid && bidder < *rival.winner);
}

Bundle::Bundle(AgentId self, std::unique_ptr<PathScore> score, std::size_t tasks,
               std::uint32_t limit)
    : self_(self), score_(std::move(score)), tasks_(tasks), limit_(limit == 0 ? tasks : limit) {}

double Bundle::warped(double gain) const {
  return claims_.empty() ? gain : std::min(gain, claims_.back().bid);
}

bool Bundle::wins(TaskId j, double gain, const std::vector<Belief>& rivals) const {
  return beats(warped(gain), self_, rivals[j.value]);
}

/// In two passes, so that tasks whose gain is only bounded are priced exactly only when they may be
/// the best.
Bundle::Choice Bundle::choose(std::vector<TaskId>& candidates, const std::vector<Belief>& rivals) {
  Choice choice;
  std::vector<std::pair<TaskId, double>> bounded;
  std::erase_if(candidates, [&](TaskId j) {
    const auto [gain, exact] = score_->bound(j);
    if (!wins(j, gain, rivals)) {
      // A gain that can only fall will not win later in this build either.
      if (!score_->diminishing()) return false;
      score_->retire(j);
      return true;
    }
    if (!exact)
      bounded.emplace_back(j, gain);
    else if (!choice.found || gain > choice.where.gain)
      choice = {j, score_->best(j), true};
    return false;
  });
  const auto better = [&choice](TaskId j, double gain) {
    if (!choice.found || gain > choice.where.gain) return true;
    return gain == choice.where.gain && j < choice.task;
  };
  for (const auto& [j, gain] : bounded) {
    if (!better(j, gain)) continue;
    const Insertion where = score_->best(j);
    if (wins(j, where.gain, rivals) && better(j, where.gain)) choice = {j, where, true};
  }
  return choice;
}

void Bundle::extend(const std::vector<Belief>& rivals) {
  score_->assign(score_->path());
  std::vector<bool> mine(tasks_, false);
  for (const Claim& claim : claims_) mine[claim.task.value] = true;
  std::vector<TaskId> candidates;
  for (std::uint32_t j = 0; j < tasks_; ++j)
    if (!mine[j]) candidates.push_back({j});
  while (claims_.size() < limit_) {
    const Choice choice = choose(candidates, rivals);
    if (!choice.found) return;
    claims_.push_back({choice.task, warped(choice.where.gain)});
    score_->insert(choice.task, choice.where);
    std::erase(candidates, choice.task);
  }
}

void Bundle::release_from(std::size_t keep) {
  if (keep >= claims_.size()) return;
  std::vector<bool> released(tasks_, false);
  for (std::size_t n = keep; n < claims_.size(); ++n) released[claims_[n].task.value] = true;
  claims_.resize(keep);
  std::vector<PathStop> path = score_->path();
  std::erase_if(path, [&](const PathStop& stop) { return released[stop.task.value]; });
  score_->assign(std::move(path));
}

}  // namespace arcbid
