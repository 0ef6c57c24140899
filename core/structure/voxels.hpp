// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/arcs/arc.hpp"

namespace arcbid {

enum class CellShape : std::uint8_t { voxel, column };  ///< a cube; a square of unlimited height

/// Points of one grid cell: indices into `points`, ascending.
struct PointCells {
  std::vector<std::uint32_t> order;   ///< all indices, cell after cell
  std::vector<std::uint32_t> starts;  ///< cell c is order[starts[c]] .. order[starts[c + 1]]
  std::size_t size() const { return starts.size() - 1; }
};

/// Groups points by cells of `cell_m`, anchored at the points' lower corner. Cells never number
/// more than 2^20 along an axis: beyond that they grow. Cells come in a fixed order.
PointCells group(const std::vector<Vec3>& points, double cell_m, CellShape shape);

/// One point a voxel: the one nearest to the voxel's centre, the first of equals. Ascending
/// indices.
std::vector<Vec3> one_per_voxel(const std::vector<Vec3>& points, double voxel_m);

}  // namespace arcbid
