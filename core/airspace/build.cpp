// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/airspace/build.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/airspace/near_field.hpp"
#include "core/airspace/runs.hpp"
#include "core/base/error.hpp"

namespace arcbid {
namespace {

// What a leg may stray over a cell's edge by rounding, and what the index of points, which works
// with floats, may be wrong by.
constexpr double kRounding_m = 1e-3;
// Cells finer than this part of the distance would cost more than they show.
constexpr double kFinest = 40;

Airspace box_around(const std::vector<Vec3>& points, const AirspaceSettings& settings) {
  Vec3 low_m = points.front(), high_m = points.front();
  for (const Vec3& p : points) {
    low_m = low_m.cwiseMin(p);
    high_m = high_m.cwiseMax(p);
  }
  Airspace out;
  for (out.cell_m = std::max(settings.cell_m, settings.required_m / kFinest);; out.cell_m *= 1.25) {
    // Outside the box all is free: so must be its outermost cells.
    const double least_m = settings.required_m + 3 * out.cell_m;
    const double margin_m = std::max(settings.margin_m, least_m);
    out.low_m = low_m - Vec3::Constant(margin_m);
    out.low_m.z() = settings.floor_m;
    const Vec3 size_m = high_m + Vec3::Constant(margin_m) - out.low_m;
    double total = 1;
    for (int axis = 0; axis < 3; ++axis) {
      const double cells = std::max(1.0, std::ceil(size_m[axis] / out.cell_m));
      total *= cells;
      out.cells[static_cast<std::size_t>(axis)] = static_cast<std::uint32_t>(std::min(cells, 1e9));
    }
    if (total <= settings.most_cells) return out;
  }
}

/// Whether all of a cell keeps the distance. `bounds`: of the distance of the cell's centre from
/// the nearest point, known from the grid alone.
bool keeps(const Clearance& clearance, const Vec3& centre, const NearField::Bounds& bounds,
           double required_m) {
  if (bounds.least_m >= required_m) return true;
  if (bounds.most_m < required_m) return false;
  return clearance.distance_m(centre) >= required_m;
}

Cells cells_that_keep(const std::vector<Vec3>& points, const Clearance& clearance,
                      const Airspace& box, double required_m) {
  const NearField field(points, box, required_m);
  Cells free;
  free.reserve(std::size_t{box.cells[0]} * box.cells[1] * box.cells[2]);
  for (std::uint32_t z = 0; z < box.cells[2]; ++z)
    for (std::uint32_t y = 0; y < box.cells[1]; ++y)
      for (std::uint32_t x = 0; x < box.cells[0]; ++x) {
        const Vec3 centre = box.low_m + box.cell_m * Vec3(x + 0.5, y + 0.5, z + 0.5);
        free.push_back(keeps(clearance, centre, field.bounds(x, y, z), required_m));
      }
  return free;
}

/// Of the cells that are 1, those stay that can be reached from the sides or the top of the box
/// through faces.
void keep_what_is_outside(Cells& free, const Airspace& box) {
  constexpr std::uint8_t reached = 2;
  const std::size_t nx = box.cells[0], ny = box.cells[1], nz = box.cells[2];
  std::vector<std::size_t> open;
  const auto reach = [&](std::size_t n) {
    if (free[n] != 1) return;
    free[n] = reached;
    open.push_back(n);
  };
  for (std::size_t z = 0; z < nz; ++z)
    for (std::size_t y = 0; y < ny; ++y)
      for (std::size_t x = 0; x < nx; ++x)
        if (x == 0 || x + 1 == nx || y == 0 || y + 1 == ny || z + 1 == nz)
          reach(x + nx * (y + ny * z));
  while (!open.empty()) {
    const std::size_t n = open.back();
    open.pop_back();
    const std::size_t x = n % nx, y = n / nx % ny, z = n / (nx * ny);
    if (x > 0) reach(n - 1);
    if (x + 1 < nx) reach(n + 1);
    if (y > 0) reach(n - nx);
    if (y + 1 < ny) reach(n + nx);
    if (z > 0) reach(n - nx * ny);
    if (z + 1 < nz) reach(n + nx * ny);
  }
  for (std::uint8_t& cell : free) cell = cell == reached;
}

}  // namespace

Airspace build_airspace(const std::vector<Vec3>& points, const Clearance& clearance,
                        const AirspaceSettings& settings) {
  check(!points.empty(), "an airspace around at least one point");
  Airspace out = box_around(points, settings);
  const double half_diagonal_m = std::sqrt(3.0) / 2 * out.cell_m;
  Cells free =
      cells_that_keep(points, clearance, out, settings.required_m + half_diagonal_m + kRounding_m);
  keep_what_is_outside(free, out);
  out.runs = encode_runs(free, out.cells);
  return out;
}

}  // namespace arcbid
