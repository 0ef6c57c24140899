// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "core/tour/tour.hpp"

namespace arcbid {

/// How long to look for a tour: by the clock, or by count.
struct TourEffort {
  double deadline_s = 0.1;
  std::optional<std::uint32_t> iterations;  ///< so many, and no clock: the same tour every time
  double (*now_s)() = wall_clock_s;         ///< by what clock

  static double wall_clock_s();
};

struct SolvedTour {
  Tour tour;
  double seconds = 0;            ///< from the arcs to the tour
  std::uint64_t iterations = 0;  ///< of the local search; rings trained where there is none
};

/// The best tour that settings.solver finds in the time given; settings.iterations has no meaning
/// here. crsom: the shortest along as many rings as there is time for, by count one; where there is
/// no time for one, a ring that is shown the arcs less often. crsom+ls: by the clock without the
/// ring where it would take more than a tenth of the time.
SolvedTour solve_tour(std::span<const TourArc> arcs, const Vec3& home_m, const Transit& transit,
                      const TourSettings& settings, const TourEffort& effort);

}  // namespace arcbid
