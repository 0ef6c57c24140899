// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/structure/bridge_arcs.hpp"
#include "core/structure/layers.hpp"
#include "core/structure/track.hpp"

namespace arcbid {

enum class Facing : std::uint8_t { up, down };

/// The rows of one layer's supplementary plane A^comp (section 2.2), as open tracks.
/// Facing up: rows over what `layer` encloses and `neighbour`, the layer above, does not; facing
/// down: rows under what the layer below does not. Neighbour null: all that the layer encloses.
/// Rows fly standoff_m from the points they face, undersides at least floor_m high or not at all.
std::vector<Track> supplementary_rows(const Layer& layer, const Layer* neighbour, Facing facing,
                                      const CoverageSettings& settings, double floor_m);

/// Cells of the grid I that a layer's hulls need, an upper bound of its viewpoints on one side.
double grid_cells(const Layer& layer, double spacing_m);

}  // namespace arcbid
