// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "core/structure/bridge_arcs.hpp"

namespace arcbid {

/// What one viewpoint a cell makes of a structure.
struct UnitDecomposition {
  std::vector<Waypoint> viewpoints;  ///< in the order in which they were chosen
  std::size_t cells = 0;             ///< that see something; the viewpoints are some of them
  std::size_t samples = 0;           ///< sided
  std::size_t covered = 0;           ///< of them: all that is seen from any of the cells
};

/// The model that the paper's Table 1 compares arcs with: the free space around the structure falls
/// into cubes; one whose middle may be flown to and sees some surface, by the sensor, is a
/// viewpoint; of these, greedily, as many are kept as it takes to see what all of them see. What
/// none of them sees is left out: unlike coverage_arcs this looks for nothing between the middles.
/// A cube's edge is spacing_m / 2: of larger ones it is chance whether any layer lies between
/// safety_m and the sensor's range. Each viewpoint is a node of its tour. A cloud's ground is
/// inspected like the rest; rows, fill and trim are not used. The same input gives the same
/// viewpoints for any number of threads. Throws InputError for illegal settings, and for structures
/// and cells that are too large.
UnitDecomposition unit_decomposition(const Structure& structure, const CoverageSettings& settings);

}  // namespace arcbid
