// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "core/arcs/mission.hpp"
#include "core/auction/task_set.hpp"

namespace arcbid {

/// What one UAV can fly, whatever that is worth. A tour is closed, home to home, as it stands in
/// path p_i; where nobody returns home (TaskSet::return_home) it ends with its last task. Lengths
/// in metres: endurance times speed.
class Limits {
 public:
  explicit Limits(const Uav& uav)
      : carried_(uav.payload),
        range_m_(uav.endurance_s ? *uav.endurance_s * uav.speed_mps * (1 + rounding)
                                 : std::numeric_limits<double>::infinity()) {}

  bool serves(const Task& task) const { return arcbid::serves(carried_, task.payload); }
  bool lasts(double tour_m) const { return tour_m <= range_m_; }

 private:
  /// Of the range: a tour that takes just as long as the UAV lasts can be flown, in whichever order
  /// its legs are added up. Whoever adds them up otherwise, as an audit may, must come to the same.
  static constexpr double rounding = 1e-9;

  Payload carried_;
  double range_m_;
};

}  // namespace arcbid
