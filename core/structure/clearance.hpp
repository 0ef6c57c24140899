// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/arcs/arc.hpp"

namespace arcbid {

/// Where a drone may fly: at least `required_m` from every one of the points, not below `floor_m`.
class Clearance {
 public:
  Clearance(const std::vector<Vec3>& points, double required_m, double floor_m);
  ~Clearance();
  Clearance(const Clearance&) = delete;
  Clearance& operator=(const Clearance&) = delete;

  double floor_m() const { return floor_m_; }

  /// The point nearest to `p`.
  Vec3 nearest(const Vec3& p) const;
  double distance_m(const Vec3& p) const { return (nearest(p) - p).norm(); }

  /// Whether all of the segment may be flown, checked continuously.
  bool clears(const Vec3& from, const Vec3& to) const;

  /// `p`, or a place at most `most_m` away to which it was pushed, straight away from what is
  /// nearest, until it may be flown. None: no such place was found.
  std::optional<Vec3> pushed_clear(const Vec3& p, double most_m) const;

 private:
  struct Index;
  std::unique_ptr<const Index> index_;
  double required_m_;
  double floor_m_;
};

}  // namespace arcbid
