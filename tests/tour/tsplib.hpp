// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/tour/tour.hpp"

namespace arcbid {

/// A TSPLIB instance whose cities are paired to arcs, and the length of the best closed tour known
/// through all of them.
struct PairedInstance {
  std::vector<TourArc> arcs;
  double best_tour_m = 0;
};

/// Reads NAME.tsp, NAME.PAIRING.pairs and arc_reference.csv; an instance without arcs where there
/// is no NAME.tsp.
PairedInstance load_instance(const std::filesystem::path& folder, const std::string& name,
                             const std::string& pairing);

}  // namespace arcbid
