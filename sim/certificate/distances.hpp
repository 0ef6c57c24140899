// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/structure/structure.hpp"
#include "sim/certificate/geometry.hpp"

namespace arcbid::certificate {

/// Exact distances from a structure: from its triangles, or from its points where it has none.
/// Embree finds what may be near, with a margin for its floats; doubles decide. Metres. May be
/// asked by several threads at once.
class Distances {
 public:
  explicit Distances(const Structure& structure);
  ~Distances();

  /// Of a point; `most_m` when the structure is no nearer than that.
  double from(const Vec3& point, double most_m) const;
  /// The least distance of a whole straight leg; `most_m` when it is no less.
  Approach from(const Vec3& leg_from, const Vec3& leg_to, double most_m) const;
  /// Numbers of the triangles (or points) that may be nearer than that, ascending.
  std::vector<std::uint32_t> near(const Vec3& point, double most_m) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace arcbid::certificate
