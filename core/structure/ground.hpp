// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/structure/structure.hpp"

namespace arcbid {

/// A cloud without the ground that was scanned with it.
struct Grounded {
  Structure structure;       ///< what is to be inspected
  std::vector<Vec3> ground;  ///< what is not, but in the way
  double ground_m = 0;       ///< z of most of the ground
  double highest_m = 0;      ///< z of its highest point
};

/// Tells ground from structure: flat places at the cloud's lowest level, with nothing above them,
/// that spread beyond all that is higher. None: a mesh, or no such places. Ground that slopes by
/// more than a metre is not recognised.
std::optional<Grounded> without_ground(const Structure& structure);

}  // namespace arcbid
