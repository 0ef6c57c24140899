// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/coverage/unit_decomposition.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/error.hpp"
#include "core/coverage/greedy_cover.hpp"
#include "core/coverage/parallel.hpp"
#include "core/coverage/visibility.hpp"
#include "core/structure/validate.hpp"
#include "core/structure/voxels.hpp"

namespace arcbid {

namespace {

constexpr double kSample_m = 0.3;  // as the arcs are planned with
constexpr double kMostCells = 2e7;

using Cell = std::array<int, 3>;

/// The cells' frame: the first layer's middles stand on the floor, or half a cell below the
/// structure's lowest point where that is higher.
struct Lattice {
  double cell_m;
  Vec3 first_m;  // middle of cell (0, 0, 0)

  Vec3 middle(const Cell& c) const { return first_m + cell_m * Vec3(c[0], c[1], c[2]); }
  int below(double at_m, int axis) const {
    return static_cast<int>(std::floor((at_m - first_m[axis]) / cell_m));
  }
};

/// The cells, first and last, that a group of points can have in range.
std::pair<Cell, Cell> box_of(const std::vector<Vec3>& points, const PointCells& groups,
                             std::size_t group, const Lattice& lattice, double range_m) {
  const std::uint32_t begin = groups.starts[group], end = groups.starts[group + 1];
  Vec3 low = points[groups.order[begin]], high = low;
  for (std::uint32_t k = begin; k < end; ++k) {
    low = low.cwiseMin(points[groups.order[k]]);
    high = high.cwiseMax(points[groups.order[k]]);
  }
  Cell first, last;
  for (int axis = 0; axis < 3; ++axis) {
    first[axis] = lattice.below(low[axis] - range_m, axis) + 1;
    last[axis] = lattice.below(high[axis] + range_m, axis);
  }
  first[2] = std::max(first[2], 0);
  return {first, last};
}

/// Cells whose middles may have some sample in range, in order. Samples near each other ask
/// together.
std::vector<Cell> cells_near(const Samples& samples, const Lattice& lattice, double range_m) {
  std::vector<Vec3> points;
  for (const Vec3f& p : samples.points) points.push_back(p.cast<double>());
  const PointCells groups = group(points, range_m, CellShape::voxel);
  std::vector<Cell> cells;
  double sum = 0;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const auto [first, last] = box_of(points, groups, g, lattice, range_m);
    double count = 1;
    for (int axis = 0; axis < 3; ++axis) count *= std::max(0, last[axis] - first[axis] + 1);
    sum += count;
    if (sum > kMostCells)
      throw InputError(
          fmt::format("coverage.spacing_m: half of {} makes more than {:.0f} cells "
                      "around the structure",
                      2 * lattice.cell_m, kMostCells));
    Cell c;
    for (c[0] = first[0]; c[0] <= last[0]; ++c[0])
      for (c[1] = first[1]; c[1] <= last[1]; ++c[1])
        for (c[2] = first[2]; c[2] <= last[2]; ++c[2]) cells.push_back(c);
  }
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

/// A viewpoint in the middle of a cell, toward the middle of what it sees from there.
struct Unit {
  Waypoint waypoint;
  Seen seen;
};
Unit unit_at(const Vec3& place, const Seer& seer, const std::vector<Wanted>& wanted) {
  Seen around = seer.around(place, wanted);
  Vec3 sum = Vec3::Zero();
  for (const std::uint32_t s : around)
    sum += (seer.samples().points[s].cast<double>() - place).normalized();
  const Vec3 toward = sum.norm() > 1e-9 ? Vec3(sum.normalized()) : Vec3(-Vec3::UnitZ());
  const Waypoint waypoint{place, seer.optics(Wanted::narrow).aim(toward)};
  Seen seen = seer.in_view(waypoint, around, wanted);
  return {waypoint, std::move(seen)};
}

/// The viewpoints of all cells, empty ones for those that cannot be flown to.
std::vector<Unit> units_of(const std::vector<Cell>& cells, const Lattice& lattice, const Seer& seer,
                           const Flyable& flyable, unsigned threads) {
  const std::vector<Wanted> wanted(seer.samples().size(), Wanted::narrow);
  std::vector<Unit> units(cells.size());
  for_chunks(cells.size(), 16, threads, [&](std::size_t from, std::size_t to) {
    for (std::size_t k = from; k < to; ++k)
      if (flyable.reaches(lattice.middle(cells[k])))
        units[k] = unit_at(lattice.middle(cells[k]), seer, wanted);
  });
  return units;
}

UnitDecomposition thinned(std::vector<Unit> units, std::size_t samples, const Vec3& origin_m) {
  UnitDecomposition result;
  result.samples = samples;
  std::vector<Seen> sets;
  for (Unit& unit : units) {
    result.cells += unit.seen.empty() ? 0 : 1;
    sets.push_back(std::move(unit.seen));
  }
  std::vector<bool> covered(samples);
  for (const std::size_t k : greedy_cover(sets, samples)) {
    const Waypoint& w = units[k].waypoint;
    result.viewpoints.push_back({w.position_m + origin_m, w.look});
    for (const std::uint32_t s : sets[k]) covered[s] = true;
  }
  result.covered = static_cast<std::size_t>(std::count(covered.begin(), covered.end(), true));
  return result;
}

}  // namespace

UnitDecomposition unit_decomposition(const Structure& structure, const CoverageSettings& settings) {
  validate(settings);
  const Bounds bounds = checked_bounds(structure);
  const unsigned threads = thread_count(settings.threads);
  const Surface surface = surface_of(structure, {}, threads);
  const Scene scene(surface);
  const double floor_m = settings.ground_m.value_or(bounds.low_m.z()) +
                         settings.ground_clearance_m - surface.origin_m.z();
  const Flyable flyable(scene, surface,
                        {settings.safety_m, floor_m, settings.sensor.range_m + settings.spacing_m},
                        threads);
  const Samples samples = sided_samples(surface, kSample_m, settings.seed);
  if (samples.size() == 0) return {};
  const Seer seer(scene, surface, samples, settings.sensor);
  const double cell_m = settings.spacing_m / 2;
  const Vec3 low = bounds.low_m - surface.origin_m - Vec3::Constant(cell_m / 2);
  const Lattice lattice{cell_m, {low.x(), low.y(), std::max(low.z(), floor_m)}};
  const std::vector<Cell> cells = cells_near(samples, lattice, settings.sensor.range_m);
  return thinned(units_of(cells, lattice, seer, flyable, threads), samples.size(),
                 surface.origin_m);
}

}  // namespace arcbid
