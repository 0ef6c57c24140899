// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/coverage/coverage_arcs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/base/error.hpp"
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

/// Nothing was seen, so trimming left nothing. What is too small to be measured is flown around all
/// the same; a sensor that sees nothing from where it may be is a mistake that its owner wants to
/// know of.
void keep_or_refuse(const std::vector<Arc>& base, const CoverageSettings& how, ArcPlan& plan) {
  if (plan.planned.samples > 0)
    throw InputError(fmt::format(
        "structure: no arc sees any of it; of {} places on its surface {} can be seen from {} to "
        "{} m with coverage.safety_m {} and coverage.ground_clearance_m {}",
        plan.planned.samples, plan.planned.visible, how.sensor.least_range_m, how.sensor.range_m,
        how.safety_m, how.ground_clearance_m));
  plan.arcs = base;
  plan.warnings.push_back(
      "the surface is too small for its coverage to be planned: arcs are those of slices and rows");
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
  const std::vector<Arc> base = plan.arcs;
  Completion(inspected, grounded ? grounded->ground : std::vector<Vec3>{},
             how.ground_m.value_or(plan.low_m.z()), how)
      .run(plan);
  if (plan.arcs.empty() && !base.empty()) keep_or_refuse(base, how, plan);
  require_arcs(plan, how);
  return plan;
}

}  // namespace arcbid
