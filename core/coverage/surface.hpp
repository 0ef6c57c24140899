// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <vector>

#include "core/structure/structure.hpp"

namespace arcbid {

using Vec3f = Eigen::Vector3f;

/// What a point of a cloud stands for.
struct Surfel {
  Vec3f point_m, normal;
  float radius_m = 0;  ///< of its sphere: together they close the surface
  float lift_m = 0;    ///< over the surface, out of all spheres near by: lines of sight start there
};

/// The structure in a frame of its own, whose origin is the middle of the structure: floats are
/// exact enough there, however far from the origin the structure lies. Metres.
struct Surface {
  Vec3 origin_m = Vec3::Zero();
  std::vector<Vec3> points;  ///< vertices, or the points of a cloud
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<Surfel> surfels;  ///< of a cloud: those to be inspected, then those of the ground
  std::size_t inspected = 0;    ///< how many of the surfels are to be inspected

  bool is_mesh() const { return !triangles.empty(); }
};

/// Without surfels: for distances alone. Vertices that no triangle uses are left out.
Surface bare_surface(const Structure& structure);

/// `ground`: points of a cloud that are in the way but not to be inspected.
Surface surface_of(const Structure& structure, const std::vector<Vec3>& ground, unsigned threads);

/// Surface samples with sides: each place gives two, one for each side of the surface.
struct Samples {
  std::vector<Vec3f> points;
  std::vector<Vec3f> normals;  ///< unit; toward the side that is to be seen
  std::vector<float> lifts_m;  ///< how far over the surface lines of sight start
  std::size_t size() const { return points.size(); }
};

/// Samples about `spacing_m` apart, the places chosen by the seed: on a mesh evenly by area, on a
/// cloud one point a voxel. Neighbours in space stand near each other. The same input gives the
/// same samples. Throws InputError for more than ten million.
Samples sided_samples(const Surface& surface, double spacing_m, std::uint64_t seed);

}  // namespace arcbid
