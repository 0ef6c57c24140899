// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/auction/score_discounted.hpp"

#include <cmath>
#include <utility>

#include "core/auction/score_distance.hpp"

namespace arcbid {

DiscountedScore::DiscountedScore(const TaskSet& set, const Uav& uav, const Transit& transit,
                                 double discount_per_s)
    : set_(set), uav_(uav), transit_(transit), discount_per_s_(discount_per_s) {
  refresh();
}

const Vec3& DiscountedScore::entry(const PathStop& stop) const {
  const Task& task = set_.tasks[stop.task.value];
  return stop.reversed ? task.last_m : task.first_m;
}

const Vec3& DiscountedScore::exit(const PathStop& stop) const {
  return entry({stop.task, !stop.reversed});
}

double DiscountedScore::transit_s(const Vec3& from, const Vec3& to) const {
  return transit_.length_m(from, to) / uav_.speed_mps;
}

void DiscountedScore::assign(std::vector<PathStop> path) {
  path_ = std::move(path);
  refresh();
}

void DiscountedScore::refresh() {
  const std::size_t n = path_.size();
  done_s_.assign(n + 1, 0.0);
  rest_value_.assign(n + 1, 0.0);
  for (std::size_t l = 0; l < n; ++l) {
    const Vec3& from = l == 0 ? uav_.home_m : exit(path_[l - 1]);
    done_s_[l + 1] = done_s_[l] + transit_s(from, entry(path_[l])) +
                     set_.tasks[path_[l].task.value].length_m() / uav_.speed_mps;
  }
  for (std::size_t l = n; l-- > 0;)
    rest_value_[l] = rest_value_[l + 1] + set_.tasks[path_[l].task.value].length_m() *
                                              std::exp(-discount_per_s_ * done_s_[l + 1]);
}

double DiscountedScore::gain(TaskId task, std::size_t position, bool reversed) const {
  const PathStop stop{task, reversed};
  const double metres = set_.tasks[task.value].length_m();
  const Vec3& from = position == 0 ? uav_.home_m : exit(path_[position - 1]);
  const double work_s = transit_s(from, entry(stop)) + metres / uav_.speed_mps;
  const double own = metres * std::exp(-discount_per_s_ * (done_s_[position] + work_s));
  if (position == path_.size()) return own;
  const Vec3& to = entry(path_[position]);
  const double delay_s = work_s + transit_s(exit(stop), to) - transit_s(from, to);
  return own + rest_value_[position] * std::expm1(-discount_per_s_ * delay_s);
}

Insertion DiscountedScore::best(TaskId task) {
  Insertion best{gain(task, 0, false), 0, false};
  for (std::uint32_t l = 0; l <= path_.size(); ++l)
    for (const bool reversed : {false, true})
      if (const double c = gain(task, l, reversed); c > best.gain) best = {c, l, reversed};
  return best;
}

void DiscountedScore::insert(TaskId task, const Insertion& where) {
  path_.insert(path_.begin() + where.position, PathStop{task, where.reversed});
  refresh();
}

std::unique_ptr<PathScore> make_score(const TaskSet& set, const Uav& uav,
                                      const AuctionSettings& settings, const Transit& transit) {
  if (settings.score == ScoreKind::discounted)
    return std::make_unique<DiscountedScore>(set, uav, transit, settings.discount_per_s);
  const bool whole_tour = settings.score == ScoreKind::minimax;
  return std::make_unique<DistanceScore>(set, uav, transit, whole_tour);
}

}  // namespace arcbid
