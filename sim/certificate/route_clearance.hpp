// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "sim/certificate/distances.hpp"
#include "sim/certificate/flight.hpp"

namespace arcbid::certificate {

/// The nearest that a route comes to the structure. Metres.
struct Nearest {
  double distance_m = std::numeric_limits<double>::infinity();  ///< infinite: nothing was flown
  std::size_t leg = 0;                                          ///< of the route, from 0
  Vec3 at_m = Vec3::Zero();
};

struct AgentClearance {
  std::uint32_t agent = 0;
  Nearest flight;            ///< of all but what `home` is for
  Nearest home;              ///< below the floor, straight over the home
  double below_floor_m = 0;  ///< flown below the floor elsewhere
};

/// Exact, continuous along every leg.
std::vector<AgentClearance> clearances(const Flown& flown, const Distances& distances,
                                       double floor_m, unsigned threads);

}  // namespace arcbid::certificate
