// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tour/rivals.hpp"

namespace arcbid {

double OrderSearch::length_m(const Order& order) {
  const Tour tour = best_directions(arcs_, order, home_m_, transit_);
  if (!has_best_ || tour.total_m < best_.total_m) best_ = tour;
  has_best_ = true;
  return tour.total_m;
}

OrderSearch::Order OrderSearch::best_order() const {
  Order order;
  for (const Stop& stop : best_.stops) order.push_back(stop.arc);
  return order;
}

SolvedTour solve_by(Rival rival, std::span<const TourArc> arcs, const Vec3& home_m,
                    const Transit& transit, std::uint64_t seed, const TourEffort& effort) {
  const double start_s = effort.now_s();
  const auto seconds = [&] { return effort.now_s() - start_s; };
  OrderSearch search(arcs, home_m, transit);
  SolvedTour out{.tour = {}, .seconds = 0, .iterations = 1};
  const GoesOn goes_on = [&] {
    const bool more =
        effort.iterations ? out.iterations < *effort.iterations : seconds() < effort.deadline_s;
    out.iterations += more ? 1 : 0;
    return more;
  };
  if (arcs.size() < 2) {
    const OrderSearch::Order order(arcs.size());  // nothing, or the only one
    search.length_m(order);
    out.tour = search.best();
    return out;
  }
  if (rival == Rival::ga) search_by_ga(search, seed, goes_on);
  if (rival == Rival::aco) search_by_aco(search, seed, goes_on);
  if (rival == Rival::pso) search_by_pso(search, seed, goes_on);
  out.tour = search.best();
  out.seconds = seconds();
  return out;
}

}  // namespace arcbid
