// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tour/solve.hpp"

#include <algorithm>

#include "core/io/process/process.hpp"
#include "core/tour/search.hpp"

namespace arcbid {
namespace {

class Clock {
 public:
  explicit Clock(const TourEffort& effort) : now_s_(effort.now_s), start_s_(now_s_()) {}
  double seconds() const { return now_s_() - start_s_; }

 private:
  double (*now_s_)();
  double start_s_;
};

/// About what an epoch takes: each input is compared with each neuron.
double epoch_s(std::size_t arcs) {
  constexpr double per_comparison_s = 1e-9, neurons_per_arc = 2.5;
  const double inputs = static_cast<double>(arcs) + 1;
  return per_comparison_s * neurons_per_arc * inputs * inputs + 1e-6 * inputs;
}

SolvedTour along_rings(std::span<const TourArc> arcs, const Vec3& home_m, const Transit& transit,
                       TourSettings settings, const TourEffort& effort) {
  const Clock clock(effort);
  if (!effort.iterations)
    settings.epochs = static_cast<std::uint32_t>(std::clamp(
        effort.deadline_s / epoch_s(arcs.size()), 1.0, static_cast<double>(settings.epochs)));
  SolvedTour out;
  double one_s = 0;
  do {
    const Tour tour = crsom_tour(arcs, home_m, transit, settings);
    if (out.iterations == 0 || tour.total_m < out.tour.total_m) out.tour = tour;
    settings.seed += 0x9e3779b97f4a7c15;  // no two runs with small seeds have a ring in common
    ++out.iterations;
    one_s = clock.seconds() / static_cast<double>(out.iterations);
  } while (!effort.iterations && clock.seconds() + one_s < effort.deadline_s);
  out.seconds = clock.seconds();
  return out;
}

}  // namespace

double TourEffort::wall_clock_s() {
  return static_cast<double>(monotonic_ns()) * 1e-9;
}

SolvedTour solve_tour(std::span<const TourArc> arcs, const Vec3& home_m, const Transit& transit,
                      const TourSettings& settings, const TourEffort& effort) {
  if (settings.solver == TourSolver::crsom)
    return along_rings(arcs, home_m, transit, settings, effort);
  const Clock clock(effort);
  SolvedTour out;
  TourSearch search(arcs, home_m, transit, settings.seed);
  if (effort.iterations || 10 * settings.epochs * epoch_s(arcs.size()) < effort.deadline_s)
    search.offer(crsom_tour(arcs, home_m, transit, settings));
  // Long enough that looking at the clock costs nothing, short enough not to miss the deadline.
  constexpr std::uint32_t slice = 10;
  const auto goes_on = [&] {
    return effort.iterations ? out.iterations < *effort.iterations
                             : clock.seconds() < effort.deadline_s;
  };
  while (goes_on()) {
    const std::uint64_t left = effort.iterations ? *effort.iterations - out.iterations : slice;
    const auto next = static_cast<std::uint32_t>(std::min<std::uint64_t>(left, slice));
    search.improve(next);
    out.iterations += next;
  }
  out.tour = search.tour();
  out.seconds = clock.seconds();
  return out;
}

}  // namespace arcbid
