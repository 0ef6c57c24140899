// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "sim/world/spec.hpp"

namespace arcbid {

/// What happens to the processes of a world, whatever they do.
struct Act {
  enum class Kind : std::uint8_t {
    start,
    crash,
    pause,
    resume,
    twin_start,
    twin_stop,
    malform,
    over_bid
  };
  TimeNs at_ns = 0;
  Kind kind = Kind::start;
  std::size_t agent = 0;  ///< position in the fleet
  Malformation malformation = Malformation::nan_bid;
  std::uint32_t count = 0;
};

/// All acts of the schedule, in the order of time; acts of one time in the order of the schedule,
/// starts first.
std::vector<Act> script_of(const WorldSpec& spec);

}  // namespace arcbid
