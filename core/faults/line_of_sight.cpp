// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/faults/line_of_sight.hpp"

#include <algorithm>
#include <utility>

namespace arcbid {

bool meets(const Obstacle& box, const Vec3& a_m, const Vec3& b_m) {
  double enters = 0, leaves = 1;  // as shares of the way from a to b
  for (int axis = 0; axis < 3; ++axis) {
    const double way = b_m[axis] - a_m[axis];
    const double to_least = box.least_m[axis] - a_m[axis], to_most = box.most_m[axis] - a_m[axis];
    if (way == 0) {
      if (to_least > 0 || to_most < 0) return false;
      continue;
    }
    const std::pair<double, double> ends = std::minmax({to_least / way, to_most / way});
    enters = std::max(enters, ends.first);
    leaves = std::min(leaves, ends.second);
  }
  return enters <= leaves;
}

}  // namespace arcbid
