// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>

#include "sim/tour/solve.hpp"

namespace arcbid {

/// What the paper's Table 2 compares CRSOM with. They search for an order; the directions are exact
/// for every order they try, as CRSOM's are.
enum class Rival : std::uint8_t { ga, aco, pso };
inline constexpr std::array<std::string_view, 3> rival_names{"ga", "aco", "pso"};

/// The best tour that a rival finds in the time given. Iterations are generations, colonies of
/// ants, or moves of the swarm; at least one is made.
SolvedTour solve_by(Rival rival, std::span<const TourArc> arcs, const Vec3& home_m,
                    const Transit& transit, std::uint64_t seed, const TourEffort& effort);

/// What the rivals share: orders are evaluated alike, and the best is kept.
class OrderSearch {
 public:
  using Order = std::vector<std::uint32_t>;

  OrderSearch(std::span<const TourArc> arcs, const Vec3& home_m, const Transit& transit)
      : arcs_(arcs), home_m_(home_m), transit_(transit) {}

  /// The length of the tour in this order, directions exact.
  double length_m(const Order& order);
  std::size_t arcs() const { return arcs_.size(); }
  std::span<const TourArc> all_arcs() const { return arcs_; }
  const Vec3& home_m() const { return home_m_; }
  const Transit& transit() const { return transit_; }
  const Tour& best() const { return best_; }
  /// The order of the best tour.
  Order best_order() const;

 private:
  std::span<const TourArc> arcs_;
  Vec3 home_m_;
  const Transit& transit_;
  Tour best_;
  bool has_best_ = false;
};

/// Each searches as long as `goes_on`, which is asked before every iteration but the first.
using GoesOn = std::function<bool()>;
void search_by_ga(OrderSearch& search, std::uint64_t seed, const GoesOn& goes_on);
void search_by_aco(OrderSearch& search, std::uint64_t seed, const GoesOn& goes_on);
void search_by_pso(OrderSearch& search, std::uint64_t seed, const GoesOn& goes_on);

}  // namespace arcbid
