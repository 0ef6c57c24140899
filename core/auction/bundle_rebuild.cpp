// SPDX-License-Identifier: GPL-3.0-or-later
// Rebuilding a bundle without doing again what must come out the same. A step of the greedy phase
// comes out the same unless the task it chose no longer wins, or a task whose rival has become
// weaker now wins and is better: all others win as before, or no longer.
#include <algorithm>
#include <utility>

#include "core/auction/bundle.hpp"

namespace arcbid {
namespace {

bool weaker(const Belief& now, const Belief& before) {
  return before.winner && now != before && beats(before.bid, *before.winner, now);
}

}  // namespace

/// Tasks outside the bundle, or later in it, that could win sooner than when the bundle was built.
std::vector<TaskId> Bundle::easier(const std::vector<Belief>& rivals) const {
  std::vector<TaskId> found;
  for (std::uint32_t j = 0; j < tasks_; ++j)
    if (weaker(rivals[j], rivals_[j])) found.push_back({j});
  return found;
}

std::size_t Bundle::still_won(const std::vector<Belief>& rivals) const {
  std::size_t kept = 0;
  while (kept < claims_.size() && beats(claims_[kept].bid, self_, rivals[claims_[kept].task.value]))
    ++kept;
  return kept;
}

/// Whether `j` would have been chosen at `step` instead of what was, the path being that of the
/// steps before.
bool Bundle::overtakes(TaskId j, std::size_t step, const std::vector<Belief>& rivals) {
  const PathScore::Bound bound = score_->bound(j);
  const bool loses = !bound.exact && !wins(j, bound.gain, step, rivals);
  const double gain = loses ? bound.gain : score_->best(j).gain;
  if (!wins(j, gain, step, rivals)) {
    if (score_->diminishing() && gain > unflyable)
      retired_at_[j.value] = static_cast<std::uint32_t>(step);
    return false;
  }
  if (step == claims_.size()) return true;
  return gain > steps_[step].gain || (gain == steps_[step].gain && j < claims_[step].task);
}

/// Takes the first `steps` steps again, or fewer: until one of `easier` interferes, which it says.
/// The path is then theirs.
bool Bundle::replay(std::size_t& steps, std::vector<TaskId> easier,
                    const std::vector<Belief>& rivals) {
  for (const TaskId j : easier) retired_at_[j.value] = never;
  score_->assign({});
  const auto interferes = [&](std::size_t n) {
    return std::any_of(easier.begin(), easier.end(), [&](TaskId j) {
      const bool chosen = n < claims_.size() && claims_[n].task == j;
      return !chosen && retired_at_[j.value] == never && overtakes(j, n, rivals);
    });
  };
  for (std::size_t n = 0; n < steps; ++n) {
    if (interferes(n)) {
      steps = n;
      return true;
    }
    score_->insert(claims_[n].task, steps_[n]);
    std::erase(easier, claims_[n].task);
  }
  return steps == claims_.size() && steps < limit_ && interferes(steps);
}

void Bundle::cut(std::size_t keep) {
  claims_.resize(keep);
  steps_.resize(keep);
  for (std::uint32_t& step : retired_at_)
    if (step >= keep) step = never;
}

bool Bundle::rebuild(const std::vector<Belief>& rivals) {
  if (!from_scratch_) {
    const std::vector<Claim> before = claims_;
    score_->assign({});
    cut(0);
    std::fill(retired_at_.begin(), retired_at_.end(), never);
    fill(rivals);
    rivals_ = rivals;
    from_scratch_ = complete_ = true;
    return claims_ != before;
  }
  std::vector<TaskId> freed = easier(rivals);
  rivals_ = rivals;
  std::size_t kept = still_won(rivals);
  const bool was_complete = std::exchange(complete_, true);
  const bool all_won = kept == claims_.size();
  if (was_complete && all_won && freed.empty()) return false;
  const bool interfered = replay(kept, std::move(freed), rivals);
  if (was_complete && all_won && !interfered) return false;
  const std::vector<Claim> before = claims_;
  cut(kept);
  fill(rivals);
  return claims_ != before;
}

}  // namespace arcbid
