// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/certificate/certificate.hpp"

namespace arcbid::certificate::testing {

/// Adds a rectangle with corner `at` and sides `a` and `b`; its normal points along a x b.
void add_plate(Structure& mesh, const Vec3& at, const Vec3& a, const Vec3& b);
/// Adds a closed box, its normals outward.
void add_box(Structure& mesh, const Vec3& low, const Vec3& high);
/// A level plate, `half` m to each side of the z axis, its normal up.
Structure level_plate(double half, double z);

/// One agent that flies these points, looking along `look`, as arc 0.
Flown flown(const std::vector<Vec3>& points, const Vec3& look = -Vec3::UnitZ());

/// Defaults with the ground at 0, and every processor.
Settings settings();

/// How many samples that `concerns` picks have this fate, of how many.
struct Counted {
  std::size_t of_fate = 0, all = 0;
};
template <class Concerns>
Counted count(const Certificate& certificate, Fate fate, const Concerns& concerns) {
  Counted counted;
  for (const SampleResult& sample : certificate.samples) {
    if (!concerns(sample)) continue;
    ++counted.all;
    counted.of_fate += sample.fate == fate ? 1 : 0;
  }
  return counted;
}

}  // namespace arcbid::certificate::testing
