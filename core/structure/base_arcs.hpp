// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/structure/bridge_arcs.hpp"

namespace arcbid {

/// As bridge_arcs, but for a structure that has no such arc the plan is empty: others may fill it.
ArcPlan base_arcs(const Structure& structure, const CoverageSettings& settings);

/// Throws InputError if there is no arc.
void require_arcs(const ArcPlan& plan, const CoverageSettings& settings);

}  // namespace arcbid
