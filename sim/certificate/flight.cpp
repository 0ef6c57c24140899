// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/certificate/flight.hpp"

#include <algorithm>
#include <cmath>

namespace arcbid::certificate {
namespace {

constexpr double count_every_m = 1.0;

/// Opposite looks have no middle: then the first one stays.
Vec3 look_between(const Vec3& first, const Vec3& second, double share) {
  const Vec3 between = (1 - share) * first + share * second;
  const double length = between.norm();
  return length > 1e-9 ? Vec3(between / length) : first;
}

}  // namespace

std::vector<Station> stations_on(const Path& path, double step_m) {
  std::vector<Station> stations;
  double since_m = count_every_m;
  const auto add = [&](const Vec3& position, const Vec3& look, double gone_m) {
    since_m += gone_m;
    const bool counts = since_m >= count_every_m;
    if (counts) since_m = 0;
    stations.push_back({position, look, counts, false});
  };
  for (std::size_t w = 0; w < path.size(); ++w) {
    if (w == 0) {
      add(path[0].position_m, path[0].look, 0);
      continue;
    }
    const Waypoint &a = path[w - 1], &b = path[w];
    const double length_m = (b.position_m - a.position_m).norm();
    const auto steps = static_cast<std::size_t>(std::max(1.0, std::ceil(length_m / step_m)));
    for (std::size_t n = 1; n <= steps; ++n) {
      const double share = static_cast<double>(n) / static_cast<double>(steps);
      add(a.position_m + share * (b.position_m - a.position_m), look_between(a.look, b.look, share),
          length_m / static_cast<double>(steps));
    }
  }
  return stations;
}

double flown_m(const Path& path) {
  double sum_m = 0;
  for (std::size_t w = 1; w < path.size(); ++w)
    sum_m += (path[w].position_m - path[w - 1].position_m).norm();
  return sum_m;
}

double flown_m(const Flown& flown) {
  double sum_m = 0;
  for (const Flight& flight : flown.flights)
    for (const FlownLeg& leg : flight.legs) sum_m += flown_m(leg.waypoints);
  return sum_m;
}

}  // namespace arcbid::certificate
