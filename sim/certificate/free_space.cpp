// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/certificate/free_space.hpp"

#include <algorithm>
#include <cmath>

#include "sim/certificate/parallel.hpp"

namespace arcbid::certificate {
namespace {

// The lower two bits of a cell: what its middle's distance says.
constexpr std::uint8_t blocked = 0;  // no position in the cell is free
constexpr std::uint8_t narrow = 1;   // its middle is not free
constexpr std::uint8_t close = 2;    // its middle is free
constexpr std::uint8_t wide = 3;  // all of the cell is free, and so is a step to a free neighbour
constexpr std::uint8_t kinds = 3;
// The others: from where its middle can be reached.
constexpr std::uint8_t over_floor = 4;  // from outside, never below the floor
constexpr std::uint8_t at_all = 8;      // from outside, were there neither floor nor ground
constexpr int beside = 2;  // the same two, so many bits higher: it, or a cell that touches it

constexpr double most_cells = 64e6;
constexpr double half_diagonal = 0.8660254037844387;  // of a cell of 1 m, rounded up

}  // namespace

/// A cube of cells, `size` along each edge.
struct FreeSpace::Block {
  Cell first;
  std::int32_t size;
};

FreeSpace::FreeSpace(const Structure& structure, const Distances& distances,
                     const FreeSpaceSettings& settings)
    : distances_(distances), settings_(settings) {
  Vec3 low = structure.points.front(), high = low;
  for (const Vec3& point : structure.points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  low.array() -= settings.around_m + settings.safety_m;
  high.array() += settings.around_m + settings.safety_m;
  const Vec3 extent = high - low;
  grid_m_ = std::max(settings.grid_m, std::cbrt(extent.prod() / most_cells));
  // Cells' middles lie on the floor, so that what is just above it is found.
  low_m_ = low;
  low_m_.z() = settings.floor_m + std::floor((low.z() - settings.floor_m) / grid_m_) * grid_m_;
  for (int axis = 0; axis < 3; ++axis)
    size_[axis] = static_cast<std::int32_t>(std::ceil((high[axis] - low_m_[axis]) / grid_m_)) + 1;
  floor_cell_ = static_cast<std::int32_t>(std::lround((settings.floor_m - low_m_.z()) / grid_m_));
  cells_.resize(static_cast<std::size_t>(size_[0]) * size_[1] * size_[2]);
  constexpr std::int32_t edge = 16;
  std::vector<Block> blocks;
  for (std::int32_t z = 0; z < size_[2]; z += edge)
    for (std::int32_t y = 0; y < size_[1]; y += edge)
      for (std::int32_t x = 0; x < size_[0]; x += edge) blocks.push_back({{x, y, z}, edge});
  in_chunks(blocks.size(), 16, settings.threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t b = first; b < last; ++b) classify(blocks[b]);
  });
  fill(true);
  fill(false);
  note_neighbours();
}

bool FreeSpace::is_inside(const Cell& cell) const {
  for (int axis = 0; axis < 3; ++axis)
    if (cell[axis] < 0 || cell[axis] >= size_[axis]) return false;
  return true;
}

std::size_t FreeSpace::index(const Cell& cell) const {
  return (static_cast<std::size_t>(cell[2]) * size_[1] + cell[1]) * size_[0] + cell[0];
}

Vec3 FreeSpace::middle(const Cell& cell) const {
  return low_m_ + grid_m_ * Vec3(cell[0], cell[1], cell[2]);
}

FreeSpace::Cell FreeSpace::cell_of(const Vec3& position) const {
  Cell cell;
  for (int axis = 0; axis < 3; ++axis)
    cell[axis] = static_cast<std::int32_t>(
                     std::clamp((position[axis] - low_m_[axis]) / grid_m_, -2.0, 2e9) + 2.5) -
                 2;
  return cell;
}

/// A distance changes by no more than one moves: one of them settles a whole block, or its eight
/// parts are asked.
void FreeSpace::classify(const Block& block) {
  if (!is_inside(block.first)) return;
  const double half_m = half_diagonal * grid_m_ * block.size;
  const double sure_m = settings_.safety_m + grid_m_;
  const Vec3 at = middle(block.first) + 0.5 * (block.size - 1) * grid_m_ * Vec3::Ones();
  const double d = distances_.from(at, sure_m + half_m);
  std::uint8_t kind = d >= sure_m + half_m || (block.size == 1 && d >= sure_m) ? wide
                      : d + half_m < settings_.safety_m                        ? blocked
                      : d >= settings_.safety_m                                ? close
                                                                               : narrow;
  if (block.size > 1 && kind != wide && kind != blocked) {
    const std::int32_t half = block.size / 2;
    for (int part = 0; part < 8; ++part) {
      Cell first = block.first;
      for (int axis = 0; axis < 3; ++axis) first[axis] += (part >> axis & 1) * half;
      classify({first, half});
    }
    return;
  }
  Cell end = block.first;
  for (int axis = 0; axis < 3; ++axis) end[axis] = std::min(end[axis] + block.size, size_[axis]);
  for (std::int32_t z = block.first[2]; z < end[2]; ++z)
    for (std::int32_t y = block.first[1]; y < end[1]; ++y)
      std::fill_n(cells_.begin() + static_cast<std::ptrdiff_t>(index({block.first[0], y, z})),
                  end[0] - block.first[0], kind);
}

/// The grid's outermost cells: nothing is near there.
std::vector<FreeSpace::Cell> FreeSpace::rim(bool with_floor) const {
  std::vector<Cell> cells;
  for (std::int32_t z = with_floor ? std::max(0, floor_cell_) : 0; z < size_[2]; ++z)
    for (std::int32_t y = 0; y < size_[1]; ++y) {
      const bool whole = z == 0 || z == size_[2] - 1 || y == 0 || y == size_[1] - 1;
      for (std::int32_t x = 0; x < size_[0]; x += whole ? 1 : std::max(1, size_[0] - 1))
        cells.push_back({x, y, z});
    }
  return cells;
}

/// From outside to all that steps between neighbours lead to. Steps that need no exact check come
/// first: after them only those into gaps are left.
void FreeSpace::fill(bool with_floor) {
  const std::uint8_t mark = with_floor ? over_floor : at_all;
  std::vector<Cell> front, unproven, none;
  for (const Cell& cell : rim(with_floor)) {
    std::uint8_t& value = cells_[index(cell)];
    if ((value & kinds) != wide) continue;
    value |= mark;
    front.push_back(cell);
  }
  spread(front, with_floor, true, unproven);
  front = std::move(unproven);
  spread(front, with_floor, false, none);
}

void FreeSpace::spread(std::vector<Cell>& front, bool with_floor, bool proven_only,
                       std::vector<Cell>& unproven) {
  while (!front.empty()) {
    const Cell cell = front.back();
    front.pop_back();
    for (int axis = 0; axis < 3; ++axis)
      for (const int step : {-1, 1}) {
        Cell next = cell;
        next[axis] += step;
        if (is_inside(next)) try_step(cell, next, with_floor, proven_only, front, unproven);
      }
  }
}

void FreeSpace::try_step(const Cell& from, const Cell& to, bool with_floor, bool proven_only,
                         std::vector<Cell>& front, std::vector<Cell>& unproven) {
  const std::uint8_t mark = with_floor ? over_floor : at_all;
  std::uint8_t& value = cells_[index(to)];
  const std::uint8_t kind = value & kinds;
  if ((value & mark) != 0 || kind < close || (with_floor && !is_over_floor(to))) return;
  const bool is_proven = kind == wide || (cells_[index(from)] & kinds) == wide;
  if (!is_proven && proven_only) {
    unproven.push_back(from);
    return;
  }
  if (!is_proven && !keeps_clear(middle(from), middle(to))) return;
  value |= mark;
  front.push_back(to);
}

bool FreeSpace::keeps_clear(const Vec3& from, const Vec3& to) const {
  return distances_.from(from, to, settings_.safety_m).distance_m >= settings_.safety_m;
}

/// Whether a free position is a clear step away from a cell's middle that is connected.
bool FreeSpace::leads_out(const Vec3& position, std::uint8_t how) const {
  const Cell own = cell_of(position);
  const Vec3 off = position - middle(own);
  for (int corner = 0; corner < 8; ++corner) {
    Cell cell = own;
    for (int axis = 0; axis < 3; ++axis)
      if ((corner >> axis & 1) != 0) cell[axis] += off[axis] > 0 ? 1 : -1;
    if (!is_inside(cell)) continue;
    const std::uint8_t value = cells_[index(cell)];
    if ((value & how) == 0) continue;
    if ((corner == 0 && (value & kinds) == wide) || keeps_clear(position, middle(cell)))
      return true;
  }
  return false;
}

/// Gives every cell the marks of all that touch it, apart from its own: one axis after another.
void FreeSpace::note_neighbours() {
  for (std::uint8_t& value : cells_)
    value |= static_cast<std::uint8_t>((value & (over_floor | at_all)) << beside);
  std::ptrdiff_t stride = 1;
  constexpr std::uint8_t marks = (over_floor | at_all) << beside;
  for (int axis = 0; axis < 3; ++axis) {
    const std::ptrdiff_t length = size_[axis], slab = stride * length;
    std::vector<std::uint8_t> before(static_cast<std::size_t>(stride));
    for (std::ptrdiff_t first = 0; first < static_cast<std::ptrdiff_t>(cells_.size());
         first += slab) {
      std::fill(before.begin(), before.end(), 0);
      for (std::ptrdiff_t at = first; at < first + slab; at += stride)
        for (std::ptrdiff_t n = 0; n < stride; ++n) {
          std::uint8_t& value = cells_[static_cast<std::size_t>(at + n)];
          const std::uint8_t own = value & marks;
          const bool is_last = at + stride == first + slab;
          const std::uint8_t next =
              is_last ? 0 : cells_[static_cast<std::size_t>(at + n + stride)] & marks;
          value |= before[static_cast<std::size_t>(n)] | next;
          before[static_cast<std::size_t>(n)] = own;
        }
    }
    stride = slab;
  }
}

Place FreeSpace::at_best(const Vec3& position) const {
  const bool is_low = position.z() < settings_.floor_m;
  const Cell own = cell_of(position);
  if (!is_inside(own)) return is_low ? Place::too_low : Place::flyable;
  const std::uint8_t value = cells_[index(own)], kind = value & kinds;
  if (kind == blocked) return Place::not_free;
  const std::uint8_t marks = kind == wide ? value : static_cast<std::uint8_t>(value >> beside);
  if (!is_low && (marks & over_floor) != 0) return Place::flyable;
  if ((marks & at_all) != 0) return Place::too_low;
  return kind >= close ? Place::pocket : Place::not_free;
}

Place FreeSpace::place(const Vec3& position) const {
  const bool is_low = position.z() < settings_.floor_m;
  const Cell cell = cell_of(position);
  if (!is_inside(cell)) return is_low ? Place::too_low : Place::flyable;
  const std::uint8_t kind = cells_[index(cell)] & kinds;
  if (kind == blocked) return Place::not_free;
  if (kind != wide && distances_.from(position, settings_.safety_m) < settings_.safety_m)
    return Place::not_free;
  if (!is_low && leads_out(position, over_floor)) return Place::flyable;
  return leads_out(position, at_all) ? Place::too_low : Place::pocket;
}

}  // namespace arcbid::certificate
