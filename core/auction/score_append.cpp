// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/auction/score_append.hpp"

#include <cmath>
#include <tuple>
#include <utility>

namespace arcbid {

AppendScore::AppendScore(const TaskSet& set, const Uav& uav, const Transit& transit,
                         double discount_per_s, bool from_home)
    : set_(set),
      uav_(uav),
      limits_(uav),
      transit_(transit),
      discount_per_s_(discount_per_s),
      from_home_(from_home),
      at_m_(uav.home_m),
      end_m_(uav.home_m) {}

double AppendScore::transit_s(const Vec3& from, const Vec3& to) const {
  return transit_.length_m(from, to) / uav_.speed_mps;
}

void AppendScore::assign(std::vector<PathStop> path) {
  at_m_ = end_m_ = uav_.home_m;
  done_s_ = flown_m_ = 0;
  path_ = std::move(path);
  for (const PathStop& stop : path_) fly(stop);
}

void AppendScore::fly(const PathStop& stop) {
  const Task& task = set_.tasks[stop.task.value];
  const auto& [entry_m, exit_m] =
      stop.reversed ? std::tie(task.last_m, task.first_m) : std::tie(task.first_m, task.last_m);
  flown_m_ += transit_.length_m(end_m_, entry_m) + task.length_m();
  end_m_ = exit_m;
  if (from_home_) return;
  done_s_ += transit_s(at_m_, entry_m) + task.length_m() / uav_.speed_mps;
  at_m_ = exit_m;
}

bool AppendScore::can_fly(const Task& task, bool reversed) const {
  const auto& [entry_m, exit_m] =
      reversed ? std::tie(task.last_m, task.first_m) : std::tie(task.first_m, task.last_m);
  const double home_m = set_.return_home ? transit_.length_m(exit_m, uav_.home_m) : 0;
  return limits_.serves(task) &&
         limits_.lasts(flown_m_ + transit_.length_m(end_m_, entry_m) + task.length_m() + home_m);
}

Insertion AppendScore::best(TaskId id) {
  const Task& task = set_.tasks[id.value];
  const double ahead_s = transit_s(at_m_, task.first_m);
  const double back_s = transit_s(at_m_, task.last_m);
  bool reversed = back_s < ahead_s;
  if (!can_fly(task, reversed)) reversed = !reversed;
  if (!can_fly(task, reversed)) return {unflyable};
  const double done_s = done_s_ + (reversed ? back_s : ahead_s) + task.length_m() / uav_.speed_mps;
  return {task.value * std::exp(-discount_per_s_ * done_s),
          static_cast<std::uint32_t>(path_.size()), reversed};
}

void AppendScore::insert(TaskId task, const Insertion& where) {
  path_.push_back({task, where.reversed});
  fly(path_.back());
}

}  // namespace arcbid
