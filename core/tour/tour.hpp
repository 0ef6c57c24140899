// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/arcs/arc.hpp"
#include "core/arcs/mission.hpp"

namespace arcbid {

/// An arc as the tour sees it: two end points and the metres between them, local East-North-Up
/// frame.
struct TourArc {
  Vec3 first_m, last_m;
  double length_m = 0;
};

/// One arc of a tour, in flying order.
struct Stop {
  std::uint32_t arc = 0;  ///< position in the span given
  bool reversed = false;  ///< flown from last_m to first_m
  friend bool operator==(const Stop&, const Stop&) = default;
};

/// A closed tour home -> stops -> home.
struct Tour {
  std::vector<Stop> stops;
  double connecting_m = 0;  ///< transits only
  double total_m = 0;       ///< transits and arcs
};

/// Asked between steps of some ms; false: the outcome is no longer wanted, and any sound one will
/// do.
using StillWanted = std::function<bool()>;

/// The order of the arcs along a clustering growing ring SOM (paper, section 3.2, eqs. 12 to 17;
/// the growth after Sasamura, Ohta, Saito 2002): positions in `arcs`, each exactly once. One neuron
/// stands for both ends of an arc: the input is their centre. Home is one more input and starts the
/// order. Inputs are scaled to their extent, so that units do not matter; where all coincide, or a
/// coordinate is not finite, the order is the one given. Time: O(epochs m^2).
std::vector<std::uint32_t> crsom_order(std::span<const TourArc> arcs, const Vec3& home_m,
                                       const TourSettings& settings);

/// For a given order the directions that make the closed tour shortest: dynamic programming, two
/// states an arc, O(m). Exact; ties choose "not reversed", the first stop first. Works for
/// asymmetric transits. `order` names each arc to visit once; an empty one stays at home.
Tour best_directions(std::span<const TourArc> arcs, std::span<const std::uint32_t> order,
                     const Vec3& home_m, const Transit& transit);

/// The same in both senses of travel; the shorter, in a tie that of `order`. Where costs are
/// asymmetric an order is one thing and the reversed order another.
Tour best_directions_either_way(std::span<const TourArc> arcs, std::vector<std::uint32_t> order,
                                const Vec3& home_m, const Transit& transit);

/// `crsom_order`, then the best directions in either sense of travel. m = 0, 1, 2 and coincident
/// points are ordinary cases.
Tour crsom_tour(std::span<const TourArc> arcs, const Vec3& home_m, const Transit& transit,
                const TourSettings& settings);

/// `starts` improved by local search, or greedy edge's tour where that is the better start, for
/// settings.iterations; never longer than the shortest of them. With the solver crsom: the shortest
/// of them. At least one start.
Tour improved_tour(std::span<const TourArc> arcs, const Vec3& home_m, const Transit& transit,
                   std::span<const Tour> starts, const TourSettings& settings,
                   const StillWanted& wanted = {});

/// `crsom_tour`, and `improved_tour` of it.
Tour plan_tour(std::span<const TourArc> arcs, const Vec3& home_m, const Transit& transit,
               const TourSettings& settings);

}  // namespace arcbid
