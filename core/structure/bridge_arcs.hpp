// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/arcs/arc.hpp"
#include "core/structure/sensor.hpp"
#include "core/structure/structure.hpp"

namespace arcbid {

enum class RowSide : std::uint8_t { short_side, long_side };

/// A cloud's points on the ground: told from the structure and not inspected, or kept.
enum class GroundPoints : std::uint8_t { automatic, keep };

/// How a structure becomes arcs (paper, section 2; all lengths in metres).
struct CoverageSettings {
  double spacing_m = 5.0;           ///< D: greatest distance between neighbouring path lines.
  double standoff_m = 4.0;          ///< distance at which the drone flies beside the surface.
  double safety_m = 2.0;            ///< least distance of any arc point from any surface point.
  double ground_clearance_m = 3.0;  ///< no arc lower than this above the ground.
  RowSide rows = RowSide::short_side;
  std::uint64_t seed = 1;          ///< of the surface samples that plan and check coverage.
  std::optional<double> ground_m;  ///< z of the ground; none: the structure's lowest point.
  Sensor sensor;
  bool fill = true;  ///< arcs also for what slices and rows leave unseen (coverage_arcs)
  bool trim = true;  ///< leave out what no sample needs, and join what is left (coverage_arcs)
  GroundPoints ground_points = GroundPoints::automatic;
  unsigned threads = 0;  ///< 0: one a processor; the result is the same for any number
};

/// What the planner knows of its own samples. Measured on other samples and the routes flown,
/// coverage is a little less: that is what the certificate is for.
struct PlannedCoverage {
  std::size_t samples = 0;  ///< sided: each place on the surface gives two
  std::size_t visible = 0;  ///< from a place that can be flown to
  std::size_t covered_by_base = 0, covered = 0;
  double base_m = 0;     ///< length of the slices' and rows' arcs
  double filled_m = 0;   ///< with those that fill gaps
  double planned_m = 0;  ///< what is left after trimming and joining
};

/// One interface from structure to arcs: every kind of structure yields this.
struct ArcPlan {
  std::vector<Arc> arcs;              ///< arcs[i].id.value == i
  std::vector<std::string> warnings;  ///< for people, one line each
  double surface_m2 = 0;              ///< area (mesh) or occupied-voxel estimate (cloud)
  /// Share of surface samples within standoff_m + spacing_m of a waypoint: an upper bound of
  /// coverage, not coverage (neither view nor incidence is asked).
  double within_reach = 0;
  PlannedCoverage planned;                           ///< all zero if gaps were not filled
  Vec3 low_m = Vec3::Zero(), high_m = Vec3::Zero();  ///< bounding box of the structure
};

/// Slices, clusters, outlines, stand-off, supplementary rows, cuts (sections 2.1 to 2.3;
/// docs/ARCS.md). Every point of every arc, between waypoints too, keeps safety_m from the surface
/// and stays above the ground clearance; neighbouring waypoints are at most spacing_m apart. The
/// same input gives the same arcs bit for bit. Throws InputError for illegal settings and when
/// nothing can be flown (no points, all points on one spot, coordinates that are not finite, a size
/// that no unit explains).
ArcPlan bridge_arcs(const Structure& structure, const CoverageSettings& settings);

}  // namespace arcbid
