// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/airspace/free_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace arcbid {
namespace {

constexpr int kMostRoom = 60;

/// The part of a segment inside the box, in shares of its length; none if low > high.
struct Share {
  double low = 0, high = 1;
};

Share within(const Vec3& from, const Vec3& step, const Cell& size) {
  Share share;
  for (int axis = 0; axis < 3; ++axis) {
    if (step[axis] == 0) {
      if (from[axis] < 0 || from[axis] > size[axis]) return {1, 0};
      continue;
    }
    const double a = -from[axis] / step[axis], b = (size[axis] - from[axis]) / step[axis];
    share.low = std::max(share.low, std::min(a, b));
    share.high = std::min(share.high, std::max(a, b));
  }
  return share;
}

/// One coordinate of a point that moves along a segment, in cells.
struct Axis {
  double from, step, per_step;
  bool back;
  int cell = 0, size = 0;

  /// To the share `at` of the segment, which is through the room's face on this axis or not.
  void advance(double at, int room, bool leaves) {
    if (leaves) {
      cell += back ? -room : room;
    } else if (per_step != 0) {
      const int there = static_cast<int>(from + at * step);
      cell = back ? std::min(cell, std::max(there, cell - room + 1))
                  : std::max(cell, std::min(there, cell + room - 1));
    }
  }
};

}  // namespace

FreeGrid::FreeGrid(const Airspace& airspace)
    : low_m_(airspace.low_m), cell_m_(airspace.cell_m), room_(decode_runs(airspace)) {
  for (std::size_t axis = 0; axis < 3; ++axis) size_[axis] = static_cast<int>(airspace.cells[axis]);
  measure_room();
}

/// The chessboard distance to the nearest cell that is not free, in two sweeps. Legs are clipped to
/// the box, so its sides do not count.
void FreeGrid::measure_room() {
  for (std::uint8_t& room : room_) room = room ? kMostRoom : 0;
  const auto sweep = [this](int sign) {
    const auto last = static_cast<std::ptrdiff_t>(room_.size()) - 1;
    const int nx = size_[0], ny = size_[1], nz = size_[2];
    for (int k = 0; k < nz; ++k)
      for (int j = 0; j < ny; ++j) {
        const std::ptrdiff_t row = (std::ptrdiff_t{k} * ny + j) * nx;
        for (int i = 0; i < nx; ++i) {
          const std::ptrdiff_t n = sign > 0 ? row + i : last - row - i;
          int least = room_[static_cast<std::size_t>(n)];
          if (least == 0) continue;
          const int x0 = i > 0 ? -1 : 0, x1 = i + 1 < nx ? 1 : 0;
          const auto look = [&](int dy, int dz, int to_x) {
            const std::ptrdiff_t at = n - sign * (std::ptrdiff_t{dz} * ny + dy) * nx;
            for (int dx = x0; dx <= to_x; ++dx)
              least = std::min(least, room_[static_cast<std::size_t>(at + sign * dx)] + 1);
          };
          if (x0 < 0) look(0, 0, -1);
          if (j > 0) look(1, 0, x1);
          if (k > 0) {
            look(0, 1, x1);
            if (j > 0) look(1, 1, x1);
            if (j + 1 < ny) look(-1, 1, x1);
          }
          room_[static_cast<std::size_t>(n)] = static_cast<std::uint8_t>(least);
        }
      }
  };
  sweep(+1);
  sweep(-1);
}

bool FreeGrid::holds(const Cell& c) const {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (c[axis] < 0 || c[axis] >= size_[axis]) return false;
  return true;
}

Vec3 FreeGrid::centre(const Cell& c) const {
  return low_m_ + cell_m_ * Vec3(c[0] + 0.5, c[1] + 0.5, c[2] + 0.5);
}

Cell FreeGrid::cell(const Vec3& p) const {
  Cell c;
  for (int axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    const double at = std::floor((p[axis] - low_m_[axis]) / cell_m_);
    c[k] = static_cast<int>(std::clamp(at, 0.0, size_[k] - 1.0));
  }
  return c;
}

Vec3 FreeGrid::clamped(const Vec3& p) const {
  const Vec3 high_m = low_m_ + cell_m_ * Vec3(size_[0], size_[1], size_[2]);
  return p.cwiseMax(low_m_).cwiseMin(high_m);
}

bool FreeGrid::inside(const Vec3& p) const {
  return clamped(p) == p;
}

bool FreeGrid::free(const Vec3& p) const {
  if (p.z() < low_m_.z()) return false;
  return !inside(p) || free(cell(p));
}

/// From cell to cell, over all that is known to be free around one at once. Cells only ever change
/// in the segment's direction, so that rounding cannot keep it from ending. Places inside the box
/// have no negative coordinates: cutting off their fractions rounds them down.
bool FreeGrid::sees(const Vec3& from, const Vec3& to) const {
  if (std::min(from.z(), to.z()) < low_m_.z()) return false;
  const Vec3 a = (from - low_m_) / cell_m_, step = (to - from) / cell_m_;
  const Share share = within(a, step, size_);
  if (share.low > share.high) return true;
  std::array<Axis, 3> axes;
  for (int k = 0; k < 3; ++k) {
    Axis& axis = axes[static_cast<std::size_t>(k)];
    axis = {a[k], step[k], step[k] == 0 ? 0 : 1 / step[k], step[k] < 0};
    axis.size = size_[static_cast<std::size_t>(k)];
    axis.cell = std::clamp(static_cast<int>(a[k] + share.low * step[k]), 0, axis.size - 1);
  }
  while (true) {
    const int room = room_[number({axes[0].cell, axes[1].cell, axes[2].cell})];
    if (room == 0) return false;
    double leave = std::numeric_limits<double>::infinity();
    Axis* through = nullptr;
    for (Axis& axis : axes) {
      if (axis.per_step == 0) continue;
      const int edge = axis.back ? axis.cell - room + 1 : axis.cell + room;
      const double at = (edge - axis.from) * axis.per_step;
      if (at >= leave) continue;
      leave = at;
      through = &axis;
    }
    if (leave >= share.high) return true;
    for (Axis& axis : axes) axis.advance(leave, room, &axis == through);
    if (through->cell < 0 || through->cell >= through->size) return true;
  }
}

}  // namespace arcbid
