// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tour/search.hpp"

#include <algorithm>
#include <numeric>

#include "core/base/error.hpp"
#include "core/tour/greedy.hpp"

namespace arcbid {

namespace {

bool all_finite(std::span<const TourArc> arcs, const Vec3& home_m) {
  return home_m.allFinite() && std::ranges::all_of(arcs, [](const TourArc& arc) {
           return arc.first_m.allFinite() && arc.last_m.allFinite();
         });
}

}  // namespace

TourSearch::TourSearch(std::span<const TourArc> arcs, const Vec3& home_m, const Transit& transit,
                       std::uint64_t seed)
    : arcs_(arcs.begin(), arcs.end()), home_m_(home_m), transit_(transit), seed_(seed) {
  if (arcs.size() < 2 || !all_finite(arcs, home_m)) return;
  costs_.emplace(arcs, home_m, transit);
  std::vector<std::uint32_t> nodes(costs_->nodes());
  std::iota(nodes.begin(), nodes.end(), 0U);
  neighbours_.emplace(*costs_, nodes);
  search_.emplace(*costs_, *neighbours_, greedy_entries(*costs_, *neighbours_), seed);
}

void TourSearch::offer(const Tour& tour) {
  if (!search_) return;
  check(tour.stops.size() == arcs_.size(), "a tour offered visits all arcs");
  std::vector<std::uint32_t> entries;
  for (const Stop& stop : tour.stops) entries.push_back(2 * stop.arc + (stop.reversed ? 1 : 0));
  entries.push_back(static_cast<std::uint32_t>(2 * arcs_.size()));  // home
  LocalSearch other(*costs_, *neighbours_, std::move(entries), seed_);
  if (other.best_cost() < search_->best_cost()) search_.emplace(std::move(other));
}

void TourSearch::improve(std::uint64_t iterations) {
  for (std::uint64_t n = 0; search_ && n < iterations; ++n) search_->disturb();
}

Tour TourSearch::tour() const {
  std::vector<std::uint32_t> order(arcs_.size());
  std::iota(order.begin(), order.end(), 0U);
  if (search_) {
    std::vector<std::uint32_t> entries = search_->best();
    const auto home = std::ranges::find(entries, arcs_.size(), [](auto node) { return node / 2; });
    std::ranges::rotate(entries, home);
    for (std::size_t n = 0; n < order.size(); ++n) order[n] = entries[n + 1] / 2;
  }
  return best_directions_either_way(arcs_, std::move(order), home_m_, transit_);
}

}  // namespace arcbid
