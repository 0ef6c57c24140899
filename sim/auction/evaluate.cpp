// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/auction/evaluate.hpp"

#include <algorithm>
#include <cmath>

namespace arcbid {

Evaluation evaluate(const Instance& instance, const std::vector<std::vector<TaskId>>& paths,
                    double discount_per_s) {
  Evaluation value;
  std::vector<std::size_t> owners(instance.tasks.tasks.size());
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const Uav& uav = instance.fleet[i];
    Vec3 at_m = uav.home_m;
    double length_m = 0;
    for (const TaskId j : paths[i]) {
      const Task& task = instance.tasks.tasks[j.value];
      length_m += (task.first_m - at_m).norm();
      at_m = task.first_m;
      value.score += task.value * std::exp(-discount_per_s * length_m / uav.speed_mps);
      ++owners[j.value];
    }
    value.sum_length_m += length_m;
    value.makespan_s = std::max(value.makespan_s, length_m / uav.speed_mps);
  }
  for (const std::size_t count : owners) {
    value.assigned += count > 0;
    value.conflicts += count > 1;
  }
  return value;
}

}  // namespace arcbid
