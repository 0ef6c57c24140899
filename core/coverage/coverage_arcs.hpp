// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/structure/bridge_arcs.hpp"

namespace arcbid {

/// Arcs that cover all that can be seen: those of bridge_arcs, further ones for what these leave
/// unseen, less what nothing needs (docs/COVERAGE.md). With neither `fill` nor `trim` exactly those
/// of bridge_arcs. Every arc keeps safety_m from the surface, waypoints and segments alike. The
/// same input gives the same arcs bit for bit, for any number of threads. Throws as
/// bridge_arcs, and where no arc sees anything.
ArcPlan coverage_arcs(const Structure& structure, const CoverageSettings& settings);

}  // namespace arcbid
