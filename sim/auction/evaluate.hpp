// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "sim/auction/instance.hpp"

namespace arcbid {

/// What paths are worth, whatever score they were bid by.
struct Evaluation {
  double score = 0;           ///< sum of v_j exp(-rho t_j), t_j the arrival at task j
  double sum_length_m = 0;    ///< of all paths, from home to the last task
  double makespan_s = 0;      ///< the slowest agent's path
  std::size_t assigned = 0;   ///< tasks with at least one owner
  std::size_t conflicts = 0;  ///< tasks with more than one
};

Evaluation evaluate(const Instance& instance, const std::vector<std::vector<TaskId>>& paths,
                    double discount_per_s);

}  // namespace arcbid
