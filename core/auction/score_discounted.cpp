// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/auction/score_discounted.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace arcbid {
namespace {

// Rounding must not make a bound smaller than what it bounds.
constexpr double slack = 1 + 1e-9;

}  // namespace

DiscountedScore::DiscountedScore(const TaskSet& set, const Uav& uav, const Transit& transit,
                                 double discount_per_s)
    : set_(set),
      uav_(uav),
      limits_(uav),
      transit_(transit),
      discount_per_s_(discount_per_s),
      slots_(set.tasks.size()) {
  for (const Task& task : set.tasks) {
    const double way_s =
        std::min(transit_s(uav_.home_m, task.first_m), transit_s(uav_.home_m, task.last_m));
    work_.push_back(discounted(task.length_m() / uav_.speed_mps));
    direct_.push_back(limits_.serves(task) ? task.value * (discounted(way_s) * work_.back()) * slack
                                           : unflyable);
  }
  refresh();
}

const Vec3& DiscountedScore::entry(const PathStop& stop) const {
  const Task& task = set_.tasks[stop.task.value];
  return stop.reversed ? task.last_m : task.first_m;
}

/// From where position `position` of the path is flown to.
const Vec3& DiscountedScore::begin(std::size_t position) const {
  return position == 0 ? uav_.home_m : exit(path_[position - 1]);
}

const Vec3& DiscountedScore::exit(const PathStop& stop) const {
  return entry({stop.task, !stop.reversed});
}

double DiscountedScore::transit_s(const Vec3& from, const Vec3& to) const {
  return transit_.length_m(from, to) / uav_.speed_mps;
}

double DiscountedScore::discounted(double seconds) const {
  return std::exp(-discount_per_s_ * seconds);
}

void DiscountedScore::assign(std::vector<PathStop> path) {
  path_ = std::move(path);
  for (const TaskId task : active_) slots_[task.value].clear();
  active_.clear();
  refresh();
}

void DiscountedScore::refresh() {
  const std::size_t n = path_.size();
  leg_.resize(n);
  leg_m_.resize(n + 1);
  tour_m_ = 0;
  discount_.assign(n + 1, 1.0);
  rest_value_.assign(n + 1, 0.0);
  double done_s = 0;
  for (std::size_t l = 0; l < n; ++l) {
    const double length_m = set_.tasks[path_[l].task.value].length_m();
    leg_m_[l] = transit_.length_m(begin(l), entry(path_[l]));
    tour_m_ += leg_m_[l] + length_m;
    const double leg_s = leg_m_[l] / uav_.speed_mps;
    done_s += leg_s + length_m / uav_.speed_mps;
    leg_[l] = discounted(leg_s);
    discount_[l + 1] = discounted(done_s);
  }
  leg_m_[n] = set_.return_home ? transit_.length_m(begin(n), uav_.home_m) : 0;
  tour_m_ += leg_m_[n];
  for (std::size_t l = n; l-- > 0;)
    rest_value_[l] = rest_value_[l + 1] + set_.tasks[path_[l].task.value].value * discount_[l + 1];
}

DiscountedScore::Slot DiscountedScore::slot(TaskId id, std::size_t position) const {
  const Task& task = set_.tasks[id.value];
  const Vec3& from = begin(position);
  const bool at_end = position == path_.size();
  const Vec3& to = at_end ? uav_.home_m : entry(path_[position]);
  const auto place = [&](const Vec3& first, const Vec3& last) {
    const double in_m = transit_.length_m(from, first);
    const double on_m = at_end && !set_.return_home ? 0 : transit_.length_m(last, to);
    Place out{discounted(in_m / uav_.speed_mps) * work_[id.value], 0,
              in_m + task.length_m() + on_m - leg_m_[position]};
    if (!at_end) out.onward = discounted(on_m / uav_.speed_mps);
    return out;
  };
  const Place ahead = place(task.first_m, task.last_m);
  // A point is the same from both sides.
  return {ahead, task.first_m == task.last_m ? ahead : place(task.last_m, task.first_m)};
}

double DiscountedScore::gain(TaskId task, const Place& place, std::size_t position) const {
  if (!limits_.serves(set_.tasks[task.value]) || !limits_.lasts(tour_m_ + place.added_m))
    return unflyable;
  const double own = set_.tasks[task.value].value * place.arrival * discount_[position];
  if (position == path_.size()) return own;
  return own + rest_value_[position] * (place.arrival * place.onward / leg_[position] - 1);
}

std::vector<DiscountedScore::Slot>& DiscountedScore::slots(TaskId task) {
  std::vector<Slot>& slots = slots_[task.value];
  if (!slots.empty()) return slots;
  slots.reserve(path_.size() + 1);
  for (std::size_t l = 0; l <= path_.size(); ++l) slots.push_back(slot(task, l));
  active_.push_back(task);
  return slots;
}

Insertion DiscountedScore::best(TaskId task) {
  const std::vector<Slot>& known = slots(task);
  Insertion best{gain(task, known[0].ahead, 0), 0, false};
  for (std::uint32_t l = 0; l < known.size(); ++l) {
    if (const double c = gain(task, known[l].ahead, l); c > best.gain) best = {c, l, false};
    if (const double c = gain(task, known[l].back, l); c > best.gain) best = {c, l, true};
  }
  return best;
}

PathScore::Bound DiscountedScore::bound(TaskId task) {
  if (slots_[task.value].empty()) return {direct_[task.value], false};
  return {best(task).gain, true};
}

void DiscountedScore::insert(TaskId task, const Insertion& where) {
  const std::uint32_t l = where.position;
  path_.insert(path_.begin() + l, PathStop{task, where.reversed});
  refresh();
  retire(task);
  for (const TaskId other : active_) {
    std::vector<Slot>& slots = slots_[other.value];
    slots[l] = slot(other, l + 1);
    slots.insert(slots.begin() + l, slot(other, l));
  }
}

void DiscountedScore::retire(TaskId task) {
  if (slots_[task.value].empty()) return;
  slots_[task.value].clear();
  std::erase(active_, task);
}

}  // namespace arcbid
