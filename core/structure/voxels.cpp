// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structure/voxels.hpp"

#include <algorithm>

namespace arcbid {

namespace {

constexpr double kMostCells = 1 << 20;  // three indices of 21 bits fit one 64-bit key

struct CellGrid {
  Vec3 low = Vec3::Zero();
  double cell_m = 1;

  CellGrid(const std::vector<Vec3>& points, double wanted_m) : cell_m(wanted_m) {
    if (points.empty()) return;
    Vec3 high = low = points.front();
    for (const Vec3& p : points) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    cell_m = std::max(wanted_m, (high - low).maxCoeff() / kMostCells);
  }
  Vec3 index(const Vec3& p) const { return ((p - low) / cell_m).array().floor(); }
  Vec3 centre(const Vec3& p) const { return low + (index(p).array() + 0.5).matrix() * cell_m; }
  std::uint64_t key(const Vec3& p, CellShape shape) const {
    const Vec3 i = index(p);
    const auto z = shape == CellShape::voxel ? static_cast<std::uint64_t>(i.z()) : 0;
    return z << 42 | static_cast<std::uint64_t>(i.y()) << 21 | static_cast<std::uint64_t>(i.x());
  }
};

}  // namespace

PointCells group(const std::vector<Vec3>& points, double cell_m, CellShape shape) {
  const CellGrid grid(points, cell_m);
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keyed(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) keyed[i] = {grid.key(points[i], shape), i};
  std::sort(keyed.begin(), keyed.end());

  PointCells cells;
  cells.order.reserve(keyed.size());
  for (std::uint32_t i = 0; i < keyed.size(); ++i) {
    if (i == 0 || keyed[i].first != keyed[i - 1].first) cells.starts.push_back(i);
    cells.order.push_back(keyed[i].second);
  }
  cells.starts.push_back(static_cast<std::uint32_t>(keyed.size()));
  return cells;
}

std::vector<Vec3> one_per_voxel(const std::vector<Vec3>& points, double voxel_m) {
  const CellGrid grid(points, voxel_m);
  const PointCells cells = group(points, voxel_m, CellShape::voxel);
  const auto off_centre = [&](std::uint32_t i) {
    return (points[i] - grid.centre(points[i])).squaredNorm();
  };
  std::vector<std::uint32_t> kept;
  for (std::size_t c = 0; c < cells.size(); ++c)
    kept.push_back(*std::min_element(
        cells.order.begin() + cells.starts[c], cells.order.begin() + cells.starts[c + 1],
        [&](std::uint32_t a, std::uint32_t b) { return off_centre(a) < off_centre(b); }));
  std::sort(kept.begin(), kept.end());

  std::vector<Vec3> thinned;
  thinned.reserve(kept.size());
  for (const std::uint32_t i : kept) thinned.push_back(points[i]);
  return thinned;
}

}  // namespace arcbid
