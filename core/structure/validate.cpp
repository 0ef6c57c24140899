// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structure/validate.hpp"

#include "core/base/error.hpp"

namespace arcbid {

namespace {

constexpr double kFarthest_m = 1e6;
constexpr std::size_t kMostElements = std::size_t{1} << 31;

void require_point(const Vec3& p, std::size_t index) {
  if (p.allFinite() && p.cwiseAbs().maxCoeff() <= kFarthest_m) return;
  throw InputError(
      fmt::format("structure: point {} is ({}, {}, {}); coordinates must be finite and within "
                  "{:.0f} m of the origin (check the file's unit and origin)",
                  index, p.x(), p.y(), p.z(), kFarthest_m));
}

}  // namespace

void require_range(const char* field, double value, double least, double most) {
  if (value >= least && value <= most) return;  // false for NaN
  throw InputError(fmt::format("{}: {} is outside [{}, {}]", field, value, least, most));
}

Bounds checked_bounds(const Structure& structure) {
  if (structure.points.empty())
    throw InputError("structure: has no points; at least two distinct points are needed");
  if (structure.points.size() >= kMostElements || structure.triangles.size() >= kMostElements)
    throw InputError(fmt::format("structure: {} points, {} triangles; at most {} are supported",
                                 structure.points.size(), structure.triangles.size(),
                                 kMostElements - 1));
  std::optional<Bounds> box;
  const auto include = [&](std::size_t i) {
    const Vec3& p = structure.points[i];
    require_point(p, i);
    if (!box) box = Bounds{p, p};
    box->low_m = box->low_m.cwiseMin(p);
    box->high_m = box->high_m.cwiseMax(p);
  };
  if (!structure.is_mesh())
    for (std::size_t i = 0; i < structure.points.size(); ++i) include(i);
  for (std::size_t t = 0; t < structure.triangles.size(); ++t)
    for (const std::uint32_t v : structure.triangles[t]) {
      if (v >= structure.points.size())
        throw InputError(
            fmt::format("structure: triangle {} refers to vertex {}; there are {} (0 to {})", t, v,
                        structure.points.size(), structure.points.size() - 1));
      include(v);
    }
  return *box;
}

void validate(const CoverageSettings& s) {
  require_range("coverage.spacing_m", s.spacing_m, 0.01, 1000);
  require_range("coverage.safety_m", s.safety_m, 0.01, 1000);
  require_range("coverage.standoff_m", s.standoff_m, 0.01, 1000);
  require_range("coverage.ground_clearance_m", s.ground_clearance_m, 0, 1000);
  if (s.ground_m) require_range("coverage.ground_m", *s.ground_m, -1e6, 1e6);
  if (s.standoff_m < 1.1 * s.safety_m)
    throw InputError(fmt::format(
        "coverage.standoff_m: {} leaves no room above coverage.safety_m {}; at least {} "
        "is legal",
        s.standoff_m, s.safety_m, 1.1 * s.safety_m));
}

}  // namespace arcbid
