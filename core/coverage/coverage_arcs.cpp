// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/coverage/coverage_arcs.hpp"

#include "core/coverage/completion.hpp"

namespace arcbid {

ArcPlan coverage_arcs(const Structure& structure, const CoverageSettings& settings) {
  ArcPlan plan = bridge_arcs(structure, settings);
  if (!settings.fill && !settings.trim) return plan;
  const double ground_m = settings.ground_m.value_or(plan.low_m.z());
  Completion(structure, {}, ground_m, settings).run(plan);
  return plan;
}

}  // namespace arcbid
