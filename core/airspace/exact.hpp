// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/coverage/scene.hpp"
#include "core/structure/structure.hpp"

namespace arcbid {

/// Exact distances from a structure, for the few ways that lead where arcs run as near to it as
/// they may: the points that stand for it elsewhere ask for some centimetres more than that.
class ExactClearance {
 public:
  /// Arcs of coverage_arcs keep `safety_m` and 2 mm in a thousand of it: so must ways from them.
  ExactClearance(const Structure& structure, double safety_m);

  double required_m() const { return required_m_; }

  /// Of a place, in the structure's frame; some metres more than required_m where that is less.
  double distance_m(const Vec3& p) const;

  /// Whether the whole segment keeps safety_m, and both ends required_m.
  bool clears(const Vec3& from, const Vec3& to) const;

 private:
  Surface surface_;
  Scene scene_;
  double required_m_, step_m_;
};

}  // namespace arcbid
