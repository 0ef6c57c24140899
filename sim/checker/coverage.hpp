// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace arcbid::checker {

/// A stretch of an arc, metres from its first waypoint, from_m <= to_m.
struct Stretch {
  double from_m = 0, to_m = 0;
  std::string whose;  ///< for messages: "task 7", "agent 1"
};

/// Why the stretches do not cover 0 .. length_m exactly once, to the millimetre over the whole arc;
/// empty when they do. At most one line for what is missing, one for what is covered twice.
std::vector<std::string> why_not_tiled(std::vector<Stretch> stretches, double length_m);

/// Metres that are in one of the two sets of stretches but not in the other.
double difference_m(std::vector<Stretch> a, std::vector<Stretch> b);

}  // namespace arcbid::checker
