// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structure/ground.hpp"

#include <algorithm>

#include "core/structure/hull.hpp"
#include "core/structure/voxels.hpp"

namespace arcbid {

namespace {

constexpr double kColumn_m = 1.0;
constexpr double kLowest_m = 1.0;      // ground is within this of the lowest point
constexpr double kRough_m = 0.5;       // and no rougher than this within a column
constexpr double kFoot_m = 0.15;       // under a structure: only what is this near to the ground
constexpr double kLeastSpread = 0.25;  // of the area of the structure's own box

struct Columns {
  PointCells cells;
  std::vector<double> low_m, high_m;
  double lowest_m = 0;

  explicit Columns(const std::vector<Vec3>& points)
      : cells(group(points, kColumn_m, CellShape::column)) {
    for (std::size_t c = 0; c < cells.size(); ++c) {
      double low = points[cells.order[cells.starts[c]]].z(), high = low;
      for (std::uint32_t k = cells.starts[c]; k < cells.starts[c + 1]; ++k) {
        low = std::min(low, points[cells.order[k]].z());
        high = std::max(high, points[cells.order[k]].z());
      }
      low_m.push_back(low);
      high_m.push_back(high);
      lowest_m = c == 0 ? low : std::min(lowest_m, low);
    }
  }
  bool flat(std::size_t c) const {
    return low_m[c] <= lowest_m + kLowest_m && high_m[c] - low_m[c] <= kRough_m;
  }
  Vec2 place(const std::vector<Vec3>& points, std::size_t c) const {
    return points[cells.order[cells.starts[c]]].head<2>();
  }
};

/// Whether the flat columns beyond the box of all others make up a good part of that box's area.
bool spreads(const std::vector<Vec3>& points, const Columns& columns) {
  Eigen::AlignedBox2d box;
  for (std::size_t c = 0; c < columns.cells.size(); ++c)
    if (!columns.flat(c)) box.extend(columns.place(points, c));
  if (box.isEmpty()) return false;
  box.min().array() -= kColumn_m;
  box.max().array() += kColumn_m;
  double beyond_m2 = 0;
  for (std::size_t c = 0; c < columns.cells.size(); ++c)
    if (columns.flat(c) && !box.contains(columns.place(points, c)))
      beyond_m2 += kColumn_m * kColumn_m;
  return beyond_m2 > kLeastSpread * box.volume();
}

double median_low_m(const Columns& columns) {
  std::vector<double> lows;
  for (std::size_t c = 0; c < columns.cells.size(); ++c)
    if (columns.flat(c)) lows.push_back(columns.low_m[c]);
  const auto middle = lows.begin() + static_cast<std::ptrdiff_t>(lows.size() / 2);
  std::nth_element(lows.begin(), middle, lows.end());
  return *middle;
}

}  // namespace

std::optional<Grounded> without_ground(const Structure& structure) {
  if (structure.is_mesh() || structure.points.empty()) return std::nullopt;
  const std::vector<Vec3>& points = structure.points;
  const Columns columns(points);
  if (!spreads(points, columns)) return std::nullopt;

  Grounded result;
  result.ground_m = median_low_m(columns);
  std::vector<bool> is_ground(points.size());
  for (std::size_t c = 0; c < columns.cells.size(); ++c)
    for (std::uint32_t k = columns.cells.starts[c]; k < columns.cells.starts[c + 1]; ++k) {
      const std::uint32_t i = columns.cells.order[k];
      is_ground[i] = columns.flat(c) || points[i].z() <= result.ground_m + kFoot_m;
    }
  result.highest_m = result.ground_m;
  for (std::size_t i = 0; i < points.size(); ++i) {
    (is_ground[i] ? result.ground : result.structure.points).push_back(points[i]);
    if (is_ground[i]) result.highest_m = std::max(result.highest_m, points[i].z());
  }
  return result;
}

}  // namespace arcbid
