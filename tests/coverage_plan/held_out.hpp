// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "core/structure/bridge_arcs.hpp"

namespace arcbid {

/// Coverage by the nominal sensor of samples that no plan was made with.
struct HeldOut {
  std::size_t samples = 0, visible = 0, covered = 0;
  double least_clearance_m = 0;  ///< along all arcs, each 0.1 m
  double share() const {
    return visible > 0 ? static_cast<double>(covered) / static_cast<double>(visible) : 1;
  }
};
HeldOut held_out(const Structure& structure, const std::vector<Arc>& arcs,
                 const CoverageSettings& settings);

}  // namespace arcbid
