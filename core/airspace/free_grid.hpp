// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/airspace/runs.hpp"
#include "core/arcs/airspace.hpp"

namespace arcbid {

using Cell = std::array<int, 3>;

/// The published cells, unpacked to answer fast whether a straight leg stays within free ones.
class FreeGrid {
 public:
  /// `airspace` is sound and not empty.
  explicit FreeGrid(const Airspace& airspace);

  const Cell& size() const { return size_; }
  double cell_m() const { return cell_m_; }
  const Vec3& low_m() const { return low_m_; }
  std::size_t number(const Cell& c) const {
    return static_cast<std::size_t>(c[0]) +
           static_cast<std::size_t>(size_[0]) *
               (static_cast<std::size_t>(c[1]) +
                static_cast<std::size_t>(size_[1]) * static_cast<std::size_t>(c[2]));
  }
  bool holds(const Cell& c) const;
  bool free(const Cell& c) const { return room_[number(c)] > 0; }
  /// Free, and a neighbour, diagonals included, is not.
  bool on_rim(const Cell& c) const { return room_[number(c)] == 1; }
  Vec3 centre(const Cell& c) const;
  /// The cell that `p` lies in, or the nearest one where it is outside the box.
  Cell cell(const Vec3& p) const;
  bool inside(const Vec3& p) const;
  /// `p`, or the point of the box nearest to it.
  Vec3 clamped(const Vec3& p) const;

  /// Whether `p` may be flown: in a free cell, or outside the box and not under the floor.
  bool free(const Vec3& p) const;
  /// Whether all of the segment may be. Exact but for rounding; a corner that it touches counts as
  /// part of it. The same answer for the same two points in the same order, on every machine.
  bool sees(const Vec3& from, const Vec3& to) const;

 private:
  void measure_room();

  Vec3 low_m_;
  double cell_m_;
  Cell size_;
  /// 0: not free. Else all cells fewer than this many steps away, diagonals included, are free.
  std::vector<std::uint8_t> room_;
};

}  // namespace arcbid
