// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/coverage/surface.hpp"

namespace arcbid {

/// What is in the way, and how near it is. Embree behind it. All in the surface's frame.
class Scene {
 public:
  explicit Scene(const Surface& surface);  ///< keeps a reference
  ~Scene();
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  /// Exact distance (in double) from the surface, or `most_m` where that is less.
  double distance_m(const Vec3& p, double most_m) const;

  /// For each of up to 8 pairs of places: whether something is in between. A bit each.
  unsigned hidden(const Vec3f* from, const Vec3f* to, int count) const;

  /// How far one sees along a unit direction, at most `most_m`.
  float free_m(const Vec3f& from, const Vec3f& direction, float most_m) const;

 private:
  struct Index;
  const Surface& surface_;
  std::unique_ptr<const Index> index_;
};

}  // namespace arcbid
