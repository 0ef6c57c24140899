// SPDX-License-Identifier: GPL-3.0-or-later
// The checker's own idea of a stretch of an arc, against how core cuts arcs.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <cmath>

#include "core/arcs/arc.hpp"
#include "sim/checker/geometry.hpp"

namespace arcbid {
namespace {

checker::Path path_of(const std::vector<Waypoint>& waypoints) {
  checker::Path path;
  for (const auto& [p, look] : waypoints)
    path.push_back({{p.x(), p.y(), p.z()}, {look.x(), look.y(), look.z()}});
  return path;
}

TEST(CoreCuts, AreTheStretchesThatTheCheckerExpects) {
  boost::random::mt19937_64 random(7);
  boost::random::uniform_real_distribution<double> unit(0, 1);
  for (int round = 0; round < 300; ++round) {
    std::vector<Waypoint> arc;
    for (int k = 0; k < 8; ++k) {
      const double x = 30 * unit(random), y = 30 * unit(random), z = 30 * unit(random);
      const double angle = 6.28 * unit(random);
      arc.push_back({Vec3(x, y, z), Vec3(std::cos(angle), std::sin(angle), 0)});
    }
    const double whole_m = length_m(arc);
    const double cut_m = whole_m * unit(random);
    // Also just beside and exactly at a waypoint.
    const double corner_m =
        length_m(part(arc, 0, whole_m)) - (arc[7].position_m - arc[6].position_m).norm();
    for (const auto& [from_m, to_m] :
         {std::pair{0.0, cut_m}, std::pair{cut_m, whole_m}, std::pair{0.0, corner_m},
          std::pair{corner_m, whole_m}, std::pair{corner_m - 4e-4, whole_m}}) {
      const std::vector<Waypoint> piece = part(arc, from_m, to_m);
      EXPECT_EQ(checker::why_not_the_stretch(path_of(piece), path_of(arc), from_m, to_m), "");
      EXPECT_EQ(checker::why_not_the_stretch(path_of(reversed(piece)), path_of(arc), to_m, from_m),
                "");
    }
  }
}

}  // namespace
}  // namespace arcbid
