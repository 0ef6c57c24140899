// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <string>
#include <vector>

#include "core/airspace/obstacle_transit.hpp"
#include "core/airspace/surroundings.hpp"
#include "core/structure/bridge_arcs.hpp"
#include "tests/structure/arc_laws.hpp"

namespace arcbid {

using Random = boost::random::mt19937_64;

inline double real(Random& random, double low, double high) {
  return boost::random::uniform_real_distribution<double>(low, high)(random);
}

/// A structure, its model, and the truth about it: exact distances from its triangles, by brute
/// force.
struct Site {
  explicit Site(Structure what, CoverageSettings how = {});

  double distance_m(const Vec3& p) const;
  /// The least distance along a way, looked at every `step_m`.
  double least_m(const std::vector<Vec3>& way, double step_m = 0.1) const;
  /// Anywhere in the box, or somewhat beside or above it, free, not under the floor.
  Vec3 free_place(Random& random) const;

  Structure structure;
  CoverageSettings settings;
  Surroundings surroundings;
  std::vector<Arc> arcs;  // none unless a test makes some
  std::vector<std::string> warnings;
  Airspace airspace;
  FreeGrid grid;
};

/// Up to six boxes, apart or through each other, on the ground or above it.
Structure some_boxes(Random& random);

/// Four walls, a floor and a roof, each 1 m thick, around an inside of 14 x 14 x 14 m.
Structure sealed_box();

}  // namespace arcbid
