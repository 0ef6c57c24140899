// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/arcs/arc.hpp"

namespace arcbid {

/// The surface to be inspected: a point cloud (no triangles) or a mesh. Metres, z up.
struct Structure {
  std::vector<Vec3> points;                             ///< cloud points, or the mesh's vertices.
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< empty for a cloud.
  bool is_mesh() const { return !triangles.empty(); }
};

/// A structure and what its owner should know about it: one line each, for people.
struct StructureInput {
  Structure structure;
  std::vector<std::string> warnings;
};

/// Surface points about `spacing_m` apart. A mesh is Monte-Carlo sampled by area (section 4.1),
/// stratified, one sample for each spacing_m^2; the same seed gives the same samples. A cloud is
/// thinned to one point a voxel, the one nearest to its centre; the seed is not used. Points come
/// in a fixed order. A mesh without area has no samples. Throws InputError as bridge_arcs does.
std::vector<Vec3> surface_samples(const Structure& structure, double spacing_m, std::uint64_t seed);

}  // namespace arcbid
