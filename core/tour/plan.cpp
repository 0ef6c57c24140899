// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/base/error.hpp"
#include "core/tour/search.hpp"
#include "core/tour/tour.hpp"

namespace arcbid {
namespace {

constexpr std::uint64_t step = 256;  // disturbances: some ms

}  // namespace

Tour best_directions_either_way(std::span<const TourArc> arcs, std::vector<std::uint32_t> order,
                                const Vec3& home_m, const Transit& transit) {
  const Tour along = best_directions(arcs, order, home_m, transit);
  std::ranges::reverse(order);
  const Tour against = best_directions(arcs, order, home_m, transit);
  return against.connecting_m < along.connecting_m ? against : along;
}

Tour crsom_tour(std::span<const TourArc> arcs, const Vec3& home_m, const Transit& transit,
                const TourSettings& settings) {
  return best_directions_either_way(arcs, crsom_order(arcs, home_m, settings), home_m, transit);
}

Tour improved_tour(std::span<const TourArc> arcs, const Vec3& home_m, const Transit& transit,
                   std::span<const Tour> starts, const TourSettings& settings,
                   const StillWanted& wanted) {
  check(!starts.empty(), "there is a tour to improve");
  const Tour& start = *std::ranges::min_element(starts, {}, &Tour::total_m);
  if (settings.solver == TourSolver::crsom) return start;
  TourSearch search(arcs, home_m, transit, settings.seed);
  for (const Tour& tour : starts) search.offer(tour);
  for (std::uint64_t left = std::uint64_t{settings.iterations} * arcs.size();
       left > 0 && (!wanted || wanted());) {
    const std::uint64_t some = std::min(left, step);
    search.improve(some);
    left -= some;
  }
  const Tour found = search.tour();
  return found.total_m < start.total_m ? found : start;
}

Tour plan_tour(std::span<const TourArc> arcs, const Vec3& home_m, const Transit& transit,
               const TourSettings& settings) {
  const Tour crsom = crsom_tour(arcs, home_m, transit, settings);
  return improved_tour(arcs, home_m, transit, std::span(&crsom, 1), settings);
}

}  // namespace arcbid
