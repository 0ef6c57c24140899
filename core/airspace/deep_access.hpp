// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/airspace/fine_lattice.hpp"

namespace arcbid {

/// Ways out for arcs deep between members, in the order of the arcs; none where there is none. One
/// search for all, from the free cells into what is not free, shortest first, until every arc is
/// met. It looks at all that is near the surface: for arcs that a search of their own gave up on.
std::vector<std::optional<Access>> deep_accesses(const std::vector<const Arc*>& arcs,
                                                 const FreeGrid& grid, const FineLattice& lattice);

}  // namespace arcbid
