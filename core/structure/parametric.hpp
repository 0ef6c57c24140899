// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/structure/structure.hpp"

namespace arcbid {

enum class BridgeKind : std::uint8_t { girder, arch, towers };

/// A bridge described by numbers (spec: parametric generator; paper 4.1). Metres; the deck runs
/// along x, is centred on y = 0, and the ground is z = 0.
struct ParametricBridge {
  BridgeKind kind = BridgeKind::girder;
  double length_m = 60.0;
  double width_m = 12.0;
  double deck_height_m = 12.0;  ///< z of the deck's top
  double deck_thickness_m = 1.0;
  std::uint32_t piers = 3;    ///< piers, or towers where these carry the deck; in equal spans
  double pier_width_m = 2.0;  ///< along x; also a tower leg's side, a rib's depth and width
  std::uint32_t girders = 4;
  double girder_depth_m = 1.5;
  double tower_height_m = 30.0;  ///< towers: z of their tops; arch: z of the crown
};

/// The bridge as a mesh of closed solids that touch but are not united: boxes (deck, girders,
/// piers, towers' legs and beams) and, for an arch, two ribs of 32 straight segments each.
/// Triangles face outward. Throws InputError naming the field (`parametric.length_m: …`).
Structure generate(const ParametricBridge& bridge);

}  // namespace arcbid
