// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/arcs/airspace.hpp"

namespace arcbid {

/// How far each cell of a box is from the nearest point, to within a cell's diagonal: a distance
/// transform that goes no farther than what is asked for. It spares nearly all exact queries.
class NearField {
 public:
  struct Bounds {
    double least_m, most_m;  ///< of the distance of a cell's centre from the nearest point
  };

  /// Only the box of `airspace` is looked at. Distances beyond `reach_m` are not told apart.
  NearField(const std::vector<Vec3>& points, const Airspace& airspace, double reach_m);

  Bounds bounds(std::uint32_t x, std::uint32_t y, std::uint32_t z) const;

 private:
  void spread(std::size_t axis);

  double cell_m_;
  int reach_;                           // in cells
  std::array<std::size_t, 3> size_;     // the box's, and what lies under it as far as it matters
  std::size_t under_;                   // layers under the box
  std::vector<std::uint16_t> squared_;  // of the distance in cells; `far`: farther than the reach
};

}  // namespace arcbid
