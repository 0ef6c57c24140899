// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structure/rows.hpp"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cmath>
#include <optional>

namespace arcbid {

namespace {

namespace bg = boost::geometry;
using Flat = bg::model::point<double, 2, bg::cs::cartesian>;
using Site = std::pair<Flat, double>;  // (x, y) and z

Vec2 flat(const Vec3& p) {
  return p.head<2>();
}

bool in_any(const std::vector<Hull>& hulls, std::size_t count, const Vec2& p, double margin_m) {
  return std::any_of(hulls.begin(), hulls.begin() + static_cast<std::ptrdiff_t>(count),
                     [&](const Hull& h) { return contains(h.ring, p, margin_m); });
}

/// The part of a hull that the neighbouring layer leaves exposed, and how high a drone flies over
/// it.
class Exposed {
 public:
  Exposed(const Layer& layer, std::size_t hull, const Layer* neighbour, Facing facing,
          double standoff_m)
      : layer_(layer),
        hull_(hull),
        neighbour_(neighbour),
        facing_(facing),
        standoff_m_(standoff_m) {
    std::vector<Site> sites;
    for (const std::uint32_t i : layer.hulls[hull].members) {
      const Vec3& p = layer.points[i];
      // The top of a pier, in the deck's layer, is on the edge of the pier's hull: it is no soffit.
      if (!covered(flat(p), standoff_m / 16)) sites.emplace_back(Flat(p.x(), p.y()), p.z());
    }
    tree_ = decltype(tree_)(sites);
  }

  /// The filter of section 2.2: inside the larger outline, outside the smaller one.
  bool has(const Vec2& p) const { return contains(layer_.hulls[hull_].ring, p) && !covered(p, 0); }

  /// z at which a drone at (x, y) is standoff_m from the nearest exposed point of the layer, on the
  /// side it faces. None: nothing within standoff_m above or below (x, y).
  std::optional<double> flight_m(const Vec2& p) const {
    const double sign = facing_ == Facing::up ? 1 : -1;
    const bg::model::box<Flat> around(Flat(p.x() - standoff_m_, p.y() - standoff_m_),
                                      Flat(p.x() + standoff_m_, p.y() + standoff_m_));
    std::optional<double> farthest;
    const auto visit = [&](const Site& site) {
      const double dx = site.first.get<0>() - p.x(), dy = site.first.get<1>() - p.y();
      // A point stands for the surface around it, so that rows over a flat one are level.
      const double beside_m = std::max(0.0, std::hypot(dx, dy) - standoff_m_ / 10);
      const double rest2 = standoff_m_ * standoff_m_ - beside_m * beside_m;
      if (rest2 <= 0) return;
      const double z = sign * site.second + std::sqrt(rest2);
      if (!farthest || z > *farthest) farthest = z;
    };
    for (auto it = tree_.qbegin(bg::index::intersects(around)); it != tree_.qend(); ++it)
      visit(*it);
    if (farthest) *farthest *= sign;
    return farthest;
  }

 private:
  bool covered(const Vec2& p, double margin_m) const {
    return (neighbour_ && in_any(neighbour_->hulls, neighbour_->hulls.size(), p, margin_m)) ||
           in_any(layer_.hulls, hull_, p, 0);  // hulls may overlap: the first one's rows serve both
  }

  const Layer& layer_;
  std::size_t hull_;
  const Layer* neighbour_;
  Facing facing_;
  double standoff_m_;
  bg::index::rtree<Site, bg::index::linear<16>> tree_;
};

/// The uniform grid I over a rectangle: the middles of cells with sides of at most `spacing_m`.
struct Grid {
  Rectangle rectangle;
  Eigen::Array2d cells;  // along u and v

  Grid(const Ring& hull, double spacing_m)
      : rectangle(smallest_rectangle(hull)),
        cells((rectangle.extent_m / spacing_m - Vec2::Constant(1e-9)).array().ceil().max(1.0)) {}

  Vec2 cell_m() const { return rectangle.extent_m.array() / cells; }
  Vec2 at(double iu, double iv) const {
    const Vec2 size_m = cell_m();
    return rectangle.at(iu * size_m.x(), iv * size_m.y());
  }
};

/// 0: rows parallel to u; 1: to v. Short-side arcs run along the side that has fewer viewpoints.
int row_axis(const Grid& grid, RowSide rows) {
  const bool u_is_short = grid.cells.x() != grid.cells.y()
                              ? grid.cells.x() < grid.cells.y()
                              : grid.rectangle.extent_m.x() <= grid.rectangle.extent_m.y();
  const int axis = u_is_short == (rows == RowSide::short_side) ? 0 : 1;
  // A row of one viewpoint is no arc: then the only line there is runs along the other side.
  return grid.cells[axis] == 1 && grid.cells[1 - axis] > 1 ? 1 - axis : axis;
}

/// Lays the rows of one hull's exposed part.
class RowLayer {
 public:
  RowLayer(const Exposed& exposed, const Grid& grid, int axis, double standoff_m, Facing facing,
           double floor_m)
      : exposed_(exposed),
        grid_(grid),
        axis_(axis),
        standoff_m_(standoff_m),
        facing_(facing),
        floor_m_(floor_m) {}

  void lay(std::vector<Track>& rows) const {
    for (double across = 0.5; across < grid_.cells[1 - axis_]; ++across) {
      Track run;
      double along = 0.5;
      for (; along < grid_.cells[axis_]; ++along) {
        const std::optional<Vec3> v = viewpoint(along, across);
        if (v) run.points.push_back(*v);
        if (!v) finish(run, along - 1, across, rows);
      }
      finish(run, along - 1, across, rows);
    }
  }

 private:
  Vec2 place(double along, double across) const {
    return axis_ == 0 ? grid_.at(along, across) : grid_.at(across, along);
  }

  std::optional<Vec3> viewpoint(double along, double across) const {
    const Vec2 p = place(along, across);
    if (!exposed_.has(p)) return std::nullopt;
    const std::optional<double> z = exposed_.flight_m(p);
    // An underside lower than this has no room below it: the lowest layer's, as a rule.
    if (!z || (facing_ == Facing::down && *z + standoff_m_ < floor_m_)) return std::nullopt;
    return Vec3(p.x(), p.y(), std::max(*z, floor_m_));
  }

  /// A lone viewpoint becomes a line through the middle half of its cell.
  void finish(Track& run, double along, double across, std::vector<Track>& rows) const {
    if (run.points.empty()) return;
    if (run.points.size() == 1) {
      const double z = run.points.front().z();
      const Vec2 from = place(along - 0.25, across), to = place(along + 0.25, across);
      run.points = {Vec3(from.x(), from.y(), z), Vec3(to.x(), to.y(), z)};
    }
    rows.push_back(std::move(run));
    run = {};
  }

  const Exposed& exposed_;
  const Grid& grid_;
  int axis_;
  double standoff_m_;
  Facing facing_;
  double floor_m_;
};

}  // namespace

double grid_cells(const Layer& layer, double spacing_m) {
  double sum = 0;
  for (const Hull& hull : layer.hulls) sum += Grid(hull.ring, spacing_m).cells.prod();
  return sum;
}

std::vector<Track> supplementary_rows(const Layer& layer, const Layer* neighbour, Facing facing,
                                      const CoverageSettings& settings, double floor_m) {
  std::vector<Track> rows;
  for (std::size_t h = 0; h < layer.hulls.size(); ++h) {
    const Exposed exposed(layer, h, neighbour, facing, settings.standoff_m);
    const Grid grid(layer.hulls[h].ring, settings.spacing_m);
    RowLayer(exposed, grid, row_axis(grid, settings.rows), settings.standoff_m, facing, floor_m)
        .lay(rows);
  }
  return rows;
}

}  // namespace arcbid
