// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "core/base/error.hpp"
#include "core/tour/tour.hpp"

namespace arcbid {

namespace {

const Vec3& exit(const TourArc& arc, bool reversed) {
  return reversed ? arc.first_m : arc.last_m;
}

/// The shortest way home from some point of the tour, and the direction of the next arc on it.
struct WayHome {
  double length_m = 0;
  bool next_reversed = false;
};

}  // namespace

Tour best_directions(std::span<const TourArc> arcs, std::span<const std::uint32_t> order,
                     const Vec3& home_m, const Transit& transit) {
  if (order.empty()) return {};
  for (const std::uint32_t position : order)
    check(position < arcs.size(), "the order names arcs that were given");

  // Backward, so that the directions are decided in flying order and ties fall on "not reversed".
  const auto onward = [&](const Vec3& from, const TourArc& next,
                          const std::array<WayHome, 2>& home_after) {
    const double forward = transit.length_m(from, next.first_m) + home_after[0].length_m;
    const double backward = transit.length_m(from, next.last_m) + home_after[1].length_m;
    return backward < forward ? WayHome{backward, true} : WayHome{forward, false};
  };
  std::vector<std::array<WayHome, 2>> home_after(order.size());  // [stop][its direction]
  for (std::size_t k = order.size(); k-- > 0;) {
    for (const bool reversed : {false, true}) {
      const Vec3& from = exit(arcs[order[k]], reversed);
      home_after[k][reversed] = k + 1 == order.size()
                                    ? WayHome{transit.length_m(from, home_m), false}
                                    : onward(from, arcs[order[k + 1]], home_after[k + 1]);
    }
  }
  const WayHome whole = onward(home_m, arcs[order[0]], home_after[0]);

  Tour tour{.stops = {}, .connecting_m = whole.length_m, .total_m = whole.length_m};
  bool reversed = whole.next_reversed;
  for (std::size_t k = 0; k < order.size(); ++k) {
    tour.stops.push_back({order[k], reversed});
    tour.total_m += arcs[order[k]].length_m;
    reversed = home_after[k][reversed].next_reversed;
  }
  return tour;
}

}  // namespace arcbid
