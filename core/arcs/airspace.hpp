// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/arcs/arc.hpp"

namespace arcbid {

/// A place on an access.
struct AccessPoint {
  Vec3 position_m = Vec3::Zero();
};

/// A way that was checked against the surface itself, from a waypoint of an arc into a free cell:
/// for arcs that run where no cell is free.
struct Access {
  ArcId arc;
  std::uint32_t waypoint = 0;       ///< of the arc; points.front() is bitwise at its position
  std::vector<AccessPoint> points;  ///< at least two; the last one lies in a free cell
};

/// Where the fleet may fly, as the coordinator publishes it (docs/AIRSPACE.md): a grid of cubes
/// around the structure. Every point of a free cell keeps the safety distance from every point of
/// the surface and can be reached from outside through free cells. Whatever is outside the box and
/// not below it is free; nothing below low_m.z(), the floor, is. No cells: no obstacles are known.
struct Airspace {
  Vec3 low_m = Vec3::Zero();             ///< lowest corner of the box
  double cell_m = 0;                     ///< edge of a cell
  std::array<std::uint32_t, 3> cells{};  ///< along x, y, z
  std::vector<std::uint8_t> runs;        ///< which cells are free: core/airspace/runs.hpp
  std::vector<Access> accesses;          ///< by arc

  bool empty() const { return cells[0] == 0; }
};

/// Digest over all of it, bit for bit.
std::uint64_t digest(const Airspace& airspace);

}  // namespace arcbid
