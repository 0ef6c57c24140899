// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/tour/tour.hpp"
#include "sim/reproduce/paper.hpp"

namespace arcbid::reproduce {

/// Cities joined two by two: a set of Table 2, or one made in its place.
struct ArcSet {
  std::string name;
  std::vector<TourArc> arcs;
  std::optional<double> best_known;  ///< length of the best tour known that flies every arc
  bool is_generated = false;
};

/// Every file of TSPLIB that `folder` ought to have and has not is named. Throws InputError.
void require_tsplib(const std::filesystem::path& folder);

/// From NAME.tsp in `folder`, joined by NAME.matching.pairs, or, where there is none, nearest pairs
/// first; the best known tour from arc_reference.csv, where that is. Without a folder, and for
/// rand200 without a file, cities at random, as many as the set has. Throws InputError.
ArcSet arc_set(const paper::TourSet& set, const std::optional<std::filesystem::path>& folder);

/// The two free cities that are nearest to each other become a pair, until none is left; of cities
/// odd in number the last is there twice.
std::vector<TourArc> nearest_pairs(std::vector<Vec3> cities);

}  // namespace arcbid::reproduce
