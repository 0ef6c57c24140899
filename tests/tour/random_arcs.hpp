// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/tour/tour.hpp"

namespace arcbid {

/// Arcs of up to some 10 m, spread over 100 m in each direction.
inline std::vector<TourArc> random_arcs(std::size_t count, std::uint64_t seed) {
  boost::random::mt19937_64 random(seed);
  boost::random::uniform_real_distribution<double> place(0, 100), reach(-5, 5);
  const auto point = [&random](auto& along) {
    const double x = along(random), y = along(random), z = along(random);
    return Vec3(x, y, z);
  };
  std::vector<TourArc> arcs;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 first = point(place);
    const Vec3 last = first + point(reach);
    arcs.push_back({first, last, (last - first).norm()});
  }
  return arcs;
}

}  // namespace arcbid
