// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/tour/tour.hpp"

namespace arcbid {

Tour plan_tour(std::span<const TourArc> arcs, const Vec3& home_m, const Transit& transit,
               const TourSettings& settings) {
  // Construction. A stage that improves the oriented tour takes its place after the directions.
  std::vector<std::uint32_t> order = crsom_order(arcs, home_m, settings);
  const Tour along_ring = best_directions(arcs, order, home_m, transit);
  // The ring knows no sense of travel; an asymmetric transit does.
  std::ranges::reverse(order);
  const Tour against_ring = best_directions(arcs, order, home_m, transit);
  return against_ring.connecting_m < along_ring.connecting_m ? against_ring : along_ring;
}

}  // namespace arcbid
