// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/structure/structure.hpp"

namespace arcbid::certificate {

/// What stands for the surface around a point of a cloud when sight is asked for.
struct Ball {
  Vec3 middle_m;
  double radius_m = 0;
};

/// Eight rays from one point: what is left to be looked at is a mask of them.
struct Rays {
  static constexpr std::size_t size = 8;
  std::array<Vec3, size> directions;  ///< unit vectors
  std::array<double, size> lengths_m;
  std::uint8_t asked = 0;  ///< bit n: ray n counts
};

/// Whether something is in between: the triangles of a mesh, the balls of a cloud. Embree answers
/// in floats around the structure's middle. May be asked by several threads at once.
class SightLines {
 public:
  SightLines(const Structure& structure, const std::vector<Ball>& balls);
  ~SightLines();

  /// The rays, of those asked, that reach their length.
  std::uint8_t open(const Vec3& from, const Rays& rays) const;
  /// How far a ray gets, at most `most_m`.
  double reach_m(const Vec3& from, const Vec3& direction, double most_m) const;
  /// How far over its surface a sample has to be put so that floats do not have it see itself.
  double least_offset_m() const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace arcbid::certificate
