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
               std::uint32_t limit, Bids bids)
    : self_(self),
      score_(std::move(score)),
      tasks_(tasks),
      limit_(limit == 0 ? tasks : limit),
      bids_(bids),
      retired_at_(tasks, never) {}

double Bundle::bid(double gain, std::size_t step) const {
  if (step == 0 || bids_ == Bids::true_gains) return gain;
  return std::min(gain, claims_[step - 1].bid);
}

bool Bundle::wins(TaskId j, double gain, std::size_t step,
                  const std::vector<Belief>& rivals) const {
  return gain > unflyable && beats(bid(gain, step), self_, rivals[j.value]);
}

/// In two passes, so that tasks whose gain is only bounded are priced exactly only when they may be
/// the best.
Bundle::Choice Bundle::choose(std::vector<TaskId>& candidates, const std::vector<Belief>& rivals) {
  const std::size_t step = claims_.size();
  Choice choice;
  std::vector<std::pair<TaskId, double>> bounded;
  std::erase_if(candidates, [&](TaskId j) {
    const auto [gain, exact] = score_->bound(j);
    if (!wins(j, gain, step, rivals)) {
      // A gain that can only fall will not win later in this build either. What cannot be flown
      // stays a candidate: around obstacles a further stop may make a tour a little shorter.
      if (!score_->diminishing() || gain == unflyable) return false;
      score_->retire(j);
      retired_at_[j.value] = static_cast<std::uint32_t>(step);
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
    if (wins(j, where.gain, step, rivals) && better(j, where.gain)) choice = {j, where, true};
  }
  return choice;
}

std::vector<TaskId> Bundle::candidates() const {
  std::vector<bool> mine(tasks_, false);
  for (const Claim& claim : claims_) mine[claim.task.value] = true;
  std::vector<TaskId> candidates;
  for (std::uint32_t j = 0; j < tasks_; ++j)
    if (!mine[j] && retired_at_[j] == never) candidates.push_back({j});
  return candidates;
}

/// From the path as it is, the tasks retired so far aside.
void Bundle::fill(const std::vector<Belief>& rivals) {
  std::vector<TaskId> open = candidates();
  while (claims_.size() < limit_) {
    const Choice choice = choose(open, rivals);
    if (!choice.found) return;
    claims_.push_back({choice.task, bid(choice.where.gain, claims_.size())});
    steps_.push_back(choice.where);
    score_->insert(choice.task, choice.where);
    std::erase(open, choice.task);
  }
}

void Bundle::extend(const std::vector<Belief>& rivals) {
  // When the last build ended nothing else won, and only weaker rivals could change that.
  const bool open = claims_.size() < limit_;
  if (open && (!complete_ || !easier(rivals).empty())) {
    score_->assign(score_->path());
    std::fill(retired_at_.begin(), retired_at_.end(), never);
    fill(rivals);
  }
  rivals_ = rivals;
  from_scratch_ = false;
  complete_ = true;
}

void Bundle::release_from(std::size_t keep) {
  if (keep >= claims_.size()) return;
  std::vector<bool> released(tasks_, false);
  for (std::size_t n = keep; n < claims_.size(); ++n) released[claims_[n].task.value] = true;
  cut(keep);
  std::vector<PathStop> path = score_->path();
  std::erase_if(path, [&](const PathStop& stop) { return released[stop.task.value]; });
  score_->assign(std::move(path));
  complete_ = false;
}

}  // namespace arcbid
