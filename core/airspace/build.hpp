// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/arcs/airspace.hpp"
#include "core/structure/clearance.hpp"
#include "core/structure/structure.hpp"

namespace arcbid {

/// What the model is made for. Metres.
struct AirspaceSettings {
  double required_m = 2;  ///< every point of a free cell is this far from every surface point
  double margin_m = 7;    ///< of the box beyond the surface points, at least
  double floor_m = 0;     ///< z under which nothing is free
  double cell_m = 0.5;    ///< edge of a cell; grown where that would be more than `most_cells`
  double most_cells = 4e6;
};

/// The free cells around a surface that `points` stand for. `clearance` is over the same points;
/// only their distance is asked. Same input, same bits. Accesses are left empty.
Airspace build_airspace(const std::vector<Vec3>& points, const Clearance& clearance,
                        const AirspaceSettings& settings);

/// Adds an access to every arc that has no point in a free cell: every point of it keeps `safety_m`
/// from the structure itself. Arcs for which there is none are taken out, the others numbered anew,
/// and `warnings` says which and why.
void connect(std::vector<Arc>& arcs, const Structure& structure, double safety_m,
             Airspace& airspace, std::vector<std::string>& warnings);

}  // namespace arcbid
