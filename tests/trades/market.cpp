// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/trades/market.hpp"

#include <algorithm>

namespace arcbid {

Market::Market(std::uint64_t seed, std::size_t fleet, std::size_t count)
    : start(fleet), dice(seed) {
  const auto point = [this](double height_m) {
    const double x = within(0, 100), y = within(0, 100);
    return Vec3(x, y, within(0, height_m));
  };
  for (std::size_t a = 0; a < fleet; ++a) traders.push_back({point(0), within(1, 3)});
  for (std::uint32_t lot = 0; lot < count; ++lot) {
    const Vec3 first_m = point(40), last_m = first_m + 0.2 * (point(40) - first_m);
    lots.push_back({first_m, last_m, within(1, 1.5) * (last_m - first_m).norm()});
    start[below(fleet)].push_back({lot, below(2) == 1});
  }
}

double Market::within(double least, double most) {
  // Boost's distribution would look for ever for something below `most` here.
  if (!(least < most)) return least;
  return boost::random::uniform_real_distribution<double>(least, most)(dice);
}

std::uint32_t Market::below(std::size_t count) {
  return static_cast<std::uint32_t>(dice() % count);
}

double plain_slowest_s(const Market& market, const Allocation& allocation, const Transit& transit) {
  double slowest_s = 0;
  for (std::size_t a = 0; a < allocation.size(); ++a) {
    std::vector<Vec3> way{market.traders[a].home_m};
    double flown_m = 0;
    for (const LotStop& stop : allocation[a]) {
      const Lot& lot = market.lots[stop.lot];
      way.push_back(stop.reversed ? lot.last_m : lot.first_m);
      way.push_back(stop.reversed ? lot.first_m : lot.last_m);
      flown_m += lot.length_m;
    }
    way.push_back(market.traders[a].home_m);
    for (std::size_t k = 0; k < way.size(); k += 2) flown_m += transit.length_m(way[k], way[k + 1]);
    slowest_s = std::max(slowest_s, flown_m / market.traders[a].speed_mps);
  }
  return slowest_s;
}

std::vector<std::size_t> flown(const Allocation& allocation, std::size_t lots) {
  std::vector<std::size_t> times(lots);
  for (const auto& path : allocation)
    for (const LotStop& stop : path) ++times.at(stop.lot);
  return times;
}

}  // namespace arcbid
