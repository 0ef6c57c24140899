// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/airspace/surroundings.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/airspace/build.hpp"
#include "core/airspace/free_grid.hpp"
#include "core/structure/cover.hpp"
#include "core/structure/validate.hpp"

namespace arcbid {
namespace {

// Homes stand on the ground: for the surface, nothing is too low.
constexpr double kNoFloor = std::numeric_limits<double>::lowest();

/// How far apart the points are that stand for the surface: as bridge_arcs has them.
double spacing_m(const CoverageSettings& settings) {
  return std::min({settings.spacing_m, settings.standoff_m, 2 * settings.safety_m}) / 16;
}

}  // namespace

struct Surroundings::Surface {
  Surface(const Structure& whole, const Bounds& bounds, const CoverageSettings& settings)
      : structure(whole),
        safety_m(settings.safety_m),
        cover(arcbid::cover(whole, spacing_m(settings))),
        clearance(cover.points, cover.clearance_m(settings.safety_m), kNoFloor) {
    how.required_m = cover.clearance_m(settings.safety_m);
    how.floor_m = settings.ground_m.value_or(bounds.low_m.z()) + settings.ground_clearance_m;
    // Path lines are flown at the stand-off: there and a little farther out, all lies in the box.
    how.margin_m = std::max(settings.standoff_m, settings.safety_m) * 1.5 + 1;
    // A line at the stand-off must be in free cells, and members twice the distance apart must
    // leave some between them.
    how.cell_m = std::min(settings.safety_m, settings.standoff_m - settings.safety_m) / 4;
  }
  Structure structure;
  double safety_m;
  Cover cover;
  Clearance clearance;
  AirspaceSettings how;
};

Surroundings::Surroundings(const Structure& structure, const CoverageSettings& settings) {
  validate(settings);
  surface_ = std::make_unique<const Surface>(structure, checked_bounds(structure), settings);
}

Surroundings::~Surroundings() = default;

double Surroundings::floor_m() const {
  return surface_->how.floor_m;
}

Airspace Surroundings::airspace(std::vector<Arc>& arcs, std::vector<std::string>& warnings) const {
  Airspace out = build_airspace(surface_->cover.points, surface_->clearance, surface_->how);
  connect(arcs, surface_->structure, surface_->safety_m, out, warnings);
  return out;
}

bool Surroundings::clear_home(const Vec3& home, const Airspace& airspace) const {
  const FreeGrid grid(airspace);
  const Vec3 top(home.x(), home.y(), std::max(home.z(), floor_m()));
  return grid.free(top) && surface_->clearance.clears(home, top);
}

}  // namespace arcbid
