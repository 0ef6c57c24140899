// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/tour/neighbours.hpp"

namespace arcbid {

/// A closed tour by greedy edge: the cheapest leg that fits, again and again. The first node of
/// each arc, in flying order, arc 0 first and entered by node 0. Ties: the lower nodes.
std::vector<std::uint32_t> greedy_entries(const TourCosts& costs, const Neighbours& neighbours);

}  // namespace arcbid
