// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <vector>

#include "core/structure/bridge_arcs.hpp"

namespace arcbid {

/// Brute force but for cells: is some point nearer than a distance? Shares nothing with the
/// planner.
class NearPoints {
 public:
  NearPoints(const std::vector<Vec3>& points, double cell_m);
  /// Distance of the nearest point, or `cell_m` if none is that near.
  double distance_m(const Vec3& p) const;

 private:
  using Cell = std::array<std::int64_t, 3>;
  Cell cell(const Vec3& p) const;
  double cell_m_;
  std::map<Cell, std::vector<Vec3>> cells_;
};

/// Points along all arcs, at most `step_m` apart, waypoints included.
std::vector<Vec3> along_arcs(const std::vector<Arc>& arcs, double step_m);

/// What holds for every plan: dense ids, finite and distinct neighbours at most spacing_m apart,
/// unit looks, arcs longer than zero, nothing under the floor, safety_m from independent surface
/// samples.
void expect_arc_laws(const ArcPlan& plan, const Structure& structure,
                     const CoverageSettings& settings);

/// A box as a mesh, turned by `yaw_rad` around z.
Structure box_mesh(const Vec3& low, const Vec3& high, double yaw_rad = 0);

/// Both, in one mesh.
Structure joined(const Structure& a, const Structure& b);

}  // namespace arcbid
