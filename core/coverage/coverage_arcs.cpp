// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/coverage/coverage_arcs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/coverage/completion.hpp"
#include "core/structure/base_arcs.hpp"
#include "core/structure/ground.hpp"
#include "core/structure/validate.hpp"

namespace arcbid {

namespace {

/// The floor keeps the paths off the ground: also where the ground is rough, and the clearance that
/// is asked for above it less than from all else.
CoverageSettings above(const Grounded& grounded, CoverageSettings settings) {
  if (!settings.ground_m) settings.ground_m = grounded.ground_m;
  constexpr double margin_m = 0.05;
  settings.ground_clearance_m =
      std::max(settings.ground_clearance_m,
               grounded.highest_m - *settings.ground_m + settings.safety_m + margin_m);
  return settings;
}

}  // namespace

ArcPlan coverage_arcs(const Structure& structure, const CoverageSettings& settings) {
  if (!settings.fill && !settings.trim) return bridge_arcs(structure, settings);
  validate(settings);
  checked_bounds(structure);
  std::optional<Grounded> grounded;
  if (settings.ground_points == GroundPoints::automatic) grounded = without_ground(structure);
  const Structure& inspected = grounded ? grounded->structure : structure;
  const CoverageSettings how = grounded ? above(*grounded, settings) : settings;

  ArcPlan plan = base_arcs(inspected, how);
  if (grounded)
    plan.warnings.push_back(
        fmt::format("{} of {} points are the ground at z = {:.2f} m: in the way, but not inspected "
                    "(coverage.ground_points: keep, if they should be)",
                    grounded->ground.size(), structure.points.size(), grounded->ground_m));
  Completion(inspected, grounded ? grounded->ground : std::vector<Vec3>{},
             how.ground_m.value_or(plan.low_m.z()), how)
      .run(plan);
  require_arcs(plan, how);
  return plan;
}

}  // namespace arcbid
