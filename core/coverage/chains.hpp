// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/coverage/flyable.hpp"

namespace arcbid {

struct ChainLimits {
  double leg_m;    ///< the longest straight leg between two views of one chain
  double chain_m;  ///< the longest chain
  double lone_m;   ///< wanted length of the line that a lone view becomes
};

/// Joins views to open polylines that may be flown: the shortest legs first, each chain then
/// improved by 2-opt. Of views on one spot all but the first move aside. A view that is left alone
/// becomes a short line. Views for which there is no room even for that are left out; `lost` counts
/// them.
std::vector<std::vector<Waypoint>> chained(const std::vector<Waypoint>& wanted,
                                           const Flyable& flyable, const ChainLimits& limits,
                                           std::size_t& lost);

}  // namespace arcbid
