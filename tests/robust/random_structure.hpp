// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <ostream>

#include "core/structure/bridge_arcs.hpp"

namespace arcbid {

enum class Make : std::uint8_t { bridge, boxes, truss, plates, spots };

/// How a structure is made and what is wrong with it. The same recipe makes the same structure.
struct Recipe {
  Make make = Make::boxes;
  std::uint32_t seed = 0;
  bool cloud = false;   ///< points on the surface instead of the mesh
  bool tiny = false;    ///< 0.1 m long
  bool far = false;     ///< 10^5 m from the origin
  bool ground = false;  ///< with the ground around it
  // Of meshes: fins on edges that two triangles have already, triangles twice, every other one
  // turned over, some without area, a vertex far away that none uses.
  bool non_manifold = false, doubled = false, flipped = false, degenerate = false, stray = false;
  // Of clouds.
  bool noisy = false, holed = false, outliers = false;
};
std::ostream& operator<<(std::ostream& out, const Recipe& recipe);

Structure make(const Recipe& recipe);

/// Every make, and now and then each of the flaws.
Recipe random_recipe(std::uint32_t seed);

}  // namespace arcbid
