// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trades/allocation.hpp"

namespace arcbid {

std::vector<double> times_s(const std::vector<Trader>& traders, const std::vector<Lot>& lots,
                            const Allocation& allocation, const Transit& transit) {
  std::vector<double> times_s;
  for (std::size_t a = 0; a < traders.size(); ++a) {
    Vec3 at_m = traders[a].home_m;
    double length_m = 0;
    for (const LotStop& stop : allocation[a]) {
      const Lot& lot = lots[stop.lot];
      length_m += transit.length_m(at_m, stop.reversed ? lot.last_m : lot.first_m) + lot.length_m;
      at_m = stop.reversed ? lot.first_m : lot.last_m;
    }
    if (!allocation[a].empty()) length_m += transit.length_m(at_m, traders[a].home_m);
    times_s.push_back(length_m / traders[a].speed_mps);
  }
  return times_s;
}

bool keeps_limits(const std::vector<Trader>& traders, const std::vector<Lot>& lots,
                  const Allocation& allocation, const std::vector<double>& times_s) {
  for (std::size_t a = 0; a < traders.size(); ++a) {
    if (times_s[a] > traders[a].endurance_s) return false;
    std::uint64_t tasks = 0;
    for (const LotStop& stop : allocation[a]) {
      if (!serves(traders[a].payload, lots[stop.lot].payload)) return false;
      tasks += lots[stop.lot].tasks;
    }
    if (tasks > traders[a].most_tasks) return false;
  }
  return true;
}

}  // namespace arcbid
