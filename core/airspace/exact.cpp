// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/airspace/exact.hpp"

#include <algorithm>

namespace arcbid {
namespace {

constexpr double kMargin = 1e-3, kStep = 1e-3;  // of the safety distance
constexpr double kFarther_m = 4;                // than required: distances that help in leaps

}  // namespace

ExactClearance::ExactClearance(const Structure& structure, double safety_m)
    : surface_(bare_surface(structure)),
      scene_(surface_),
      required_m_(safety_m * (1 + kMargin)),
      // Between two places so far apart that keep required_m, a segment keeps safety_m.
      step_m_(safety_m * kStep) {}

double ExactClearance::distance_m(const Vec3& p) const {
  return scene_.distance_m(p - surface_.origin_m, required_m_ + kFarther_m);
}

bool ExactClearance::clears(const Vec3& from, const Vec3& to) const {
  const double length_m = (to - from).norm();
  for (double at_m = 0;;) {
    const Vec3 p = at_m < length_m ? Vec3(from + at_m / length_m * (to - from)) : to;
    const double spare_m = distance_m(p) - required_m_;
    if (spare_m < 0) return false;
    if (at_m >= length_m || spare_m >= length_m - at_m) return true;
    at_m += std::max(spare_m, step_m_);
  }
}

}  // namespace arcbid
