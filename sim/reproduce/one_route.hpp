// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/arcs/airspace.hpp"
#include "sim/certificate/flight.hpp"

namespace arcbid::reproduce {

/// What one UAV flies that takes all arcs, home to home: in the order that missions would find
/// (CRSOM and local search), and on legs around what
/// is in the way. The order is that of straight legs: the lengths of all others among thousands of
/// end points would take minutes.
certificate::Flown one_route(const std::vector<Arc>& arcs, const Airspace& airspace,
                             const Vec3& home_m);

}  // namespace arcbid::reproduce
