// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/tour/local_search.hpp"

namespace arcbid {

/// Local search for the shortest closed tour, in steps: the caller decides when to stop, by count
/// or by clock. The same calls give the same tour.
class TourSearch {
 public:
  /// Begins with greedy edge, brought to a local optimum. `transit` must outlive this; `arcs` need
  /// not. Where a coordinate is not finite nothing is searched.
  TourSearch(std::span<const TourArc> arcs, const Vec3& home_m, const Transit& transit,
             std::uint64_t seed);
  TourSearch(const TourSearch&) = delete;  // its parts refer to each other
  TourSearch& operator=(const TourSearch&) = delete;

  /// A tour over all arcs; goes on from its local optimum where that is shorter than what there is.
  void offer(const Tour& tour);
  /// So many disturbances more.
  void improve(std::uint64_t iterations);
  /// The best so far, directions exact.
  Tour tour() const;

 private:
  std::vector<TourArc> arcs_;
  Vec3 home_m_;
  const Transit& transit_;
  std::uint64_t seed_;
  std::optional<TourCosts> costs_;
  std::optional<Neighbours> neighbours_;
  std::optional<LocalSearch> search_;  // none: there is nothing to search
};

}  // namespace arcbid
