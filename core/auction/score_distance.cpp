// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/auction/score_distance.hpp"

#include <algorithm>
#include <utility>

namespace arcbid {
namespace {

constexpr double rounding = 1e-9;  // of a sum of lengths: more than it ever comes to

}  // namespace

void DistanceScore::Lengths::resize(std::size_t size) {
  for (auto* lengths : {&to_first, &to_last, &from_first, &from_last}) lengths->resize(size);
}

DistanceScore::DistanceScore(const TaskSet& set, const Uav& uav, const Transit& transit, Gain gain)
    : set_(set), uav_(uav), limits_(uav), transit_(transit), gain_(gain) {
  assign({});
}

const Vec3& DistanceScore::entry(const PathStop& stop) const {
  const Task& task = set_.tasks[stop.task.value];
  return stop.reversed ? task.last_m : task.first_m;
}

const Vec3& DistanceScore::exit(const PathStop& stop) const {
  return entry({stop.task, !stop.reversed});
}

void DistanceScore::add(Points& points, std::size_t before, const Vec3& point) const {
  points.insert(before, point, transit_.place(point));
}

/// The transit into position l of the path as it is.
double DistanceScore::leg_m(std::size_t position) const {
  if (position >= after_.size()) return 0;
  return transit_.length_m(before_.at(position), after_.at(position));
}

void DistanceScore::assign(std::vector<PathStop> path) {
  path_ = std::move(path);
  before_.clear();
  after_.clear();
  add(before_, before_.size(), uav_.home_m);
  for (const PathStop& stop : path_) {
    add(after_, after_.size(), entry(stop));
    add(before_, before_.size(), exit(stop));
  }
  if (set_.return_home) add(after_, after_.size(), uav_.home_m);
  transits_m_.clear();
  tour_m_ = 0;
  for (std::size_t l = 0; l <= path_.size(); ++l) {
    transits_m_.push_back(leg_m(l));
    tour_m_ += transits_m_.back();
    if (l < path_.size()) tour_m_ += set_.tasks[path_[l].task.value].length_m();
  }
  active_.clear();
  firsts_.clear();
  lasts_.clear();
  cached_.assign(set_.tasks.size(), {});
}

/// What a task adds to a transit of `leg_m`: entry number `n` of `lengths`, flown the shorter way.
double DistanceScore::detour_m(const Lengths& lengths, std::size_t n, double leg_m,
                               bool& reversed) const {
  const double ahead = lengths.to_first[n] + lengths.from_last[n];
  const double back = lengths.to_last[n] + lengths.from_first[n];
  reversed = back < ahead;
  return (reversed ? back : ahead) - leg_m;
}

/// The best of all positions, the earlier one on ties.
void DistanceScore::scan(TaskId task) {
  const Vec3 &first = entry({task, false}), &last = exit({task, false});
  scanned_.resize(before_.size());
  if (after_.size() < before_.size()) scanned_.from_first.back() = scanned_.from_last.back() = 0;
  transit_.lengths_m(before_, first, scanned_.to_first.data());
  transit_.lengths_m(before_, last, scanned_.to_last.data());
  transit_.lengths_m(first, after_, scanned_.from_first.data());
  transit_.lengths_m(last, after_, scanned_.from_last.data());
  Cached& best = cached_[task.value];
  best.exact = true;
  for (std::uint32_t l = 0; l < before_.size(); ++l) {
    bool reversed = false;
    const double detour = detour_m(scanned_, l, transits_m_[l], reversed);
    if (l > 0 && !(detour < best.detour_m)) continue;
    best.detour_m = detour;
    best.position = l;
    best.reversed = reversed;
  }
}

DistanceScore::Cached& DistanceScore::known(TaskId task) {
  Cached& cached = cached_[task.value];
  if (cached.slot != none) return cached;
  scan(task);
  cached.slot = static_cast<std::uint32_t>(active_.size());
  active_.push_back(task);
  add(firsts_, firsts_.size(), entry({task, false}));
  add(lasts_, lasts_.size(), exit({task, false}));
  return cached;
}

double DistanceScore::gain(double detour_m, TaskId task) const {
  const double length_m = set_.tasks[task.value].length_m();
  const double added_m = detour_m + length_m;
  const double whole_m = tour_m_ + added_m;
  if (!limits_.serves(set_.tasks[task.value]) || !limits_.lasts(whole_m)) return unflyable;
  if (gain_ == Gain::added) return -added_m / uav_.speed_mps;
  return -(gain_ == Gain::long_first ? whole_m - 2 * length_m : whole_m) / uav_.speed_mps;
}

/// Of a task that was never scanned: to do more is not shorter, but for rounding. Against rivals
/// that is mostly enough.
PathScore::Bound DistanceScore::bound(TaskId task) {
  const Cached& cached = cached_[task.value];
  if (cached.slot != none) return {gain(cached.detour_m, task), cached.exact};
  const double length_m = set_.tasks[task.value].length_m();
  return {gain(-length_m - rounding * (tour_m_ + length_m), task), false};
}

Insertion DistanceScore::best(TaskId task) {
  if (!known(task).exact) scan(task);
  const Cached& c = cached_[task.value];
  return {gain(c.detour_m, task), c.position, c.reversed};
}

/// What the way into and out of `position` would be for each of the active tasks.
void DistanceScore::measure(std::size_t position, Lengths& lengths) const {
  lengths.resize(active_.size());
  const Vec3 from = before_.at(position);
  transit_.lengths_m(from, firsts_, lengths.to_first.data());
  transit_.lengths_m(from, lasts_, lengths.to_last.data());
  if (position >= after_.size()) {
    std::fill(lengths.from_first.begin(), lengths.from_first.end(), 0.0);
    std::fill(lengths.from_last.begin(), lengths.from_last.end(), 0.0);
    return;
  }
  const Vec3 to = after_.at(position);
  transit_.lengths_m(firsts_, to, lengths.from_first.data());
  transit_.lengths_m(lasts_, to, lengths.from_last.data());
}

/// Transit `split` of the path became two, `split` and `split + 1`: only these are new, only the
/// old one is gone.
void DistanceScore::update(std::uint32_t split) {
  for (std::uint32_t k = 0; k < 2; ++k) measure(split + k, fresh_[k]);
  for (std::size_t n = 0; n < active_.size(); ++n) {
    Cached& c = cached_[active_[n].value];
    if (c.position == split)
      c.exact = false;
    else if (c.position > split)
      ++c.position;
    for (std::uint32_t k = 0; k < 2; ++k) {
      bool reversed = false;
      const double detour = detour_m(fresh_[k], n, transits_m_[split + k], reversed);
      const bool earlier = c.exact && detour == c.detour_m && split + k < c.position;
      if (!(detour < c.detour_m || earlier)) continue;
      c.detour_m = detour;
      c.position = split + k;
      c.reversed = reversed;
      c.exact = true;
    }
  }
}

void DistanceScore::insert(TaskId task, const Insertion& where) {
  const std::uint32_t l = where.position;
  const PathStop stop{task, where.reversed};
  const double old_leg_m = transits_m_[l];
  path_.insert(path_.begin() + l, stop);
  add(before_, l + 1, exit(stop));
  add(after_, l, entry(stop));
  transits_m_[l] = leg_m(l);
  transits_m_.insert(transits_m_.begin() + l + 1, leg_m(l + 1));
  tour_m_ += transits_m_[l] + transits_m_[l + 1] - old_leg_m + set_.tasks[task.value].length_m();
  retire(task);
  if (!active_.empty()) update(l);
}

void DistanceScore::retire(TaskId task) {
  const std::uint32_t slot = std::exchange(cached_[task.value].slot, none);
  if (slot == none) return;
  active_[slot] = active_.back();
  active_.pop_back();
  if (slot < active_.size()) cached_[active_[slot].value].slot = slot;
  firsts_.remove(slot);
  lasts_.remove(slot);
}

}  // namespace arcbid
