// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/airspace/free_grid.hpp"

namespace arcbid {

/// Leaves out the points that the way can do without.
void shorten(const FreeGrid& grid, std::vector<Vec3>& way);

/// Pulls the string: leaves out points, and moves the others as far toward the straight line
/// between their neighbours as free cells allow. All of a way that was free stays so, and it never
/// becomes longer.
void pull(const FreeGrid& grid, std::vector<Vec3>& way);

/// The same of a way that was pulled before its last point was added: only its end is looked at.
void pull_end(const FreeGrid& grid, std::vector<Vec3>& way);

}  // namespace arcbid
