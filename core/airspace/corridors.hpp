// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/airspace/free_grid.hpp"
#include "core/arcs/airspace.hpp"

namespace arcbid {

/// A way from a place to a point from which free cells can be flown.
struct Door {
  std::vector<Vec3> way;  ///< from the place to that point; one point where the place is free
  double length_m = 0;    ///< of the way
  const Vec3& at() const { return way.back(); }
};

/// A point of an arc.
struct OnArc {
  std::uint32_t arc = 0;
  std::uint32_t segment = 0;  ///< from waypoint `segment` to the next
};

/// Ways out of places. Arcs were checked against the surface itself, so they may be flown where no
/// cell is free: as far as the nearest point of theirs that lies in one.
class Corridors {
 public:
  /// Keeps references to all three.
  Corridors(const std::vector<Arc>& arcs, const Airspace& airspace, const FreeGrid& grid);

  /// A free place is its own door. One under the floor goes straight up to it. One on an arc has
  /// up to one door each way along the arc, and one through each access. Others have none.
  std::vector<Door> doors(const Vec3& place, const std::optional<OnArc>& on) const;

  /// The first arc that holds a place in no free cell, to a micrometre.
  std::optional<OnArc> find(const Vec3& place) const;

  /// The way along the arc, both ends included.
  std::vector<Vec3> along(const OnArc& from, const Vec3& from_m, const OnArc& to,
                          const Vec3& to_m) const;

 private:
  std::optional<Door> walk(const Vec3& place, const OnArc& on, int sense) const;

  const std::vector<Arc>& arcs_;
  const Airspace& airspace_;
  const FreeGrid& grid_;
};

/// Of a polyline: the sum is the same bit for bit from either end.
double way_length_m(const std::vector<Vec3>& way);

}  // namespace arcbid
