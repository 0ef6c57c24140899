// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/structure/bridge_arcs.hpp"
#include "core/structure/hull.hpp"

namespace arcbid {

/// A_i: one slice. It holds every point of a slab around its level, so that each point of the
/// structure belongs to exactly one layer.
struct Layer {
  double level_m = 0;        ///< z at which its outlines are flown
  std::vector<Vec3> points;  ///< of the slab
  double high_m = 0;         ///< z of the highest of them; 0 if there are none
  std::vector<Hull> hulls;   ///< of the points' clusters; none for an empty slab
};

/// Cuts the points into layers, top first (the set B of section 2.1). Slabs are of equal thickness,
/// at most spacing_m, from the highest point down; their middle is the level, never under floor_m.
/// Throws InputError for more than 5000 layers, or 2000 clusters in one.
std::vector<Layer> slice(const std::vector<Vec3>& points, const CoverageSettings& settings,
                         double floor_m);

}  // namespace arcbid
