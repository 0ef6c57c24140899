// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/structure/structure.hpp"
#include "sim/certificate/sight_lines.hpp"

namespace arcbid::certificate {

/// A point of the surface; it stands for area_m2 of it, and is looked at from both sides.
struct SurfacePoint {
  Vec3 position_m;
  Vec3 normal;  ///< unit; which side it shows does not matter
  double area_m2 = 0;
  double offset_m = 0;  ///< sight lines begin so far above the surface
};

/// The surface as the certificate sees it.
struct Surface {
  std::vector<SurfacePoint> points;  ///< without the ground
  std::vector<SurfacePoint> ground;
  double spacing_m = 0;     ///< one point for each spacing_m^2
  std::vector<Ball> balls;  ///< of a cloud: what blocks sight
};

struct SurfaceSettings {
  double spacing_m = 0.3;
  std::uint64_t seed = 1;
  unsigned threads = 0;
};

/// A mesh by area, stratified; of a cloud one point a voxel, its normal from its neighbours.
Surface surface_of(const Structure& structure, const SurfaceSettings& settings);

/// Without the vertices that no triangle uses: they are not part of the surface, and wherever they
/// are, they would widen its box and lower its ground. Corners must exist.
Structure used_part(const Structure& mesh);

/// The two kinds, without the ground being told apart.
void sample_mesh(const Structure& mesh, const SurfaceSettings& settings, Surface& surface);
void sample_cloud(const Structure& cloud, const SurfaceSettings& settings, Surface& surface);

/// Moves to `ground` what lies flat at the lowest level, if that level spreads beyond what stands
/// on it (docs/COVERAGE.md).
void set_ground_aside(Surface& surface);

/// A number that looks random and depends on these two alone.
std::uint64_t mixed(std::uint64_t seed, std::uint64_t number);
/// The same in [0, 1).
double share_of(std::uint64_t bits);

}  // namespace arcbid::certificate
