// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/auction/score_distance.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace arcbid {

DistanceScore::DistanceScore(const TaskSet& set, const Uav& uav, const Transit& transit,
                             bool whole_tour)
    : set_(set), uav_(uav), transit_(transit), whole_tour_(whole_tour) {
  assign({});
}

const Vec3& DistanceScore::entry(const PathStop& stop) const {
  const Task& task = set_.tasks[stop.task.value];
  return stop.reversed ? task.last_m : task.first_m;
}

const Vec3& DistanceScore::exit(const PathStop& stop) const {
  return entry({stop.task, !stop.reversed});
}

const Vec3& DistanceScore::before(std::size_t position) const {
  return position == 0 ? uav_.home_m : exit(path_[position - 1]);
}

/// The transit into position l of the path as it is.
double DistanceScore::leg_m(std::size_t position) const {
  if (position < path_.size()) return transit_.length_m(before(position), entry(path_[position]));
  return set_.return_home ? transit_.length_m(before(position), uav_.home_m) : 0.0;
}

void DistanceScore::assign(std::vector<PathStop> path) {
  path_ = std::move(path);
  transits_m_.clear();
  tour_m_ = 0;
  for (std::size_t l = 0; l <= path_.size(); ++l) {
    transits_m_.push_back(leg_m(l));
    tour_m_ += transits_m_.back();
    if (l < path_.size()) tour_m_ += set_.tasks[path_[l].task.value].length_m();
  }
  active_.clear();
  cached_.assign(set_.tasks.size(), {});
}

DistanceScore::Cached DistanceScore::at(TaskId task, std::uint32_t position) const {
  const Vec3 &first = entry({task, false}), &last = exit({task, false});
  const Vec3& from = before(position);
  double ahead = transit_.length_m(from, first), back = transit_.length_m(from, last);
  if (position < path_.size() || set_.return_home) {
    const Vec3& to = position < path_.size() ? entry(path_[position]) : uav_.home_m;
    ahead += transit_.length_m(last, to);
    back += transit_.length_m(first, to);
  }
  const bool reversed = back < ahead;
  return {(reversed ? back : ahead) - transits_m_[position], position, reversed, true, true};
}

void DistanceScore::scan(TaskId task) {
  Cached best = at(task, 0);
  for (std::uint32_t l = 1; l <= path_.size(); ++l) {
    const Cached other = at(task, l);
    if (other.detour_m < best.detour_m) best = other;
  }
  cached_[task.value] = best;
}

DistanceScore::Cached& DistanceScore::known(TaskId task) {
  if (!cached_[task.value].known) {
    scan(task);
    active_.push_back(task);
  }
  return cached_[task.value];
}

double DistanceScore::gain(TaskId task) const {
  const double added_m = cached_[task.value].detour_m + set_.tasks[task.value].length_m();
  return -(whole_tour_ ? tour_m_ + added_m : added_m) / uav_.speed_mps;
}

PathScore::Bound DistanceScore::bound(TaskId task) {
  const bool exact = known(task).exact;
  return {gain(task), exact};
}

Insertion DistanceScore::best(TaskId task) {
  if (!known(task).exact) scan(task);
  const Cached& c = cached_[task.value];
  return {gain(task), c.position, c.reversed};
}

/// Transit `split` of the path became two, `split` and `split + 1`: only these are new, only the
/// old one is gone.
void DistanceScore::update(TaskId task, std::uint32_t split) {
  Cached& c = cached_[task.value];
  if (c.position == split)
    c.exact = false;
  else if (c.position > split)
    ++c.position;
  for (const std::uint32_t position : {split, split + 1}) {
    const Cached fresh = at(task, position);
    const bool earlier = c.exact && fresh.detour_m == c.detour_m && fresh.position < c.position;
    if (fresh.detour_m < c.detour_m || earlier) c = fresh;
  }
}

void DistanceScore::insert(TaskId task, const Insertion& where) {
  const std::uint32_t l = where.position;
  tour_m_ += at(task, l).detour_m + set_.tasks[task.value].length_m();
  path_.insert(path_.begin() + l, PathStop{task, where.reversed});
  transits_m_[l] = leg_m(l);
  transits_m_.insert(transits_m_.begin() + l + 1, leg_m(l + 1));
  retire(task);
  for (const TaskId other : active_) update(other, l);
}

void DistanceScore::retire(TaskId task) {
  if (!cached_[task.value].known) return;
  cached_[task.value].known = false;
  std::erase(active_, task);
}

}  // namespace arcbid
