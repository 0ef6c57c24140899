// SPDX-License-Identifier: GPL-3.0-or-later
// What is compared with must be sound, or the comparison says nothing.
#include "sim/tour/rivals.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "tests/tour/random_arcs.hpp"

namespace arcbid {
namespace {

const StraightTransit straight;
const Vec3 home(50, 50, 0);

TourEffort counted(std::uint32_t iterations) {
  TourEffort effort;
  effort.iterations = iterations;
  return effort;
}

SolvedTour solved(Rival rival, const std::vector<TourArc>& arcs, std::uint32_t iterations,
                  std::uint64_t seed = 1) {
  return solve_by(rival, arcs, home, straight, seed, counted(iterations));
}

class Rivals : public ::testing::TestWithParam<Rival> {};

TEST_P(Rivals, VisitEveryArcOnceAndMeasureItRightly) {
  const auto arcs = random_arcs(20, 3);
  const Tour tour = solved(GetParam(), arcs, 20).tour;
  std::vector<std::uint32_t> order;
  double flown_m = 0;
  Vec3 at = home;
  for (const Stop& stop : tour.stops) {
    order.push_back(stop.arc);
    const TourArc& arc = arcs[stop.arc];
    flown_m += (at - (stop.reversed ? arc.last_m : arc.first_m)).norm() + arc.length_m;
    at = stop.reversed ? arc.first_m : arc.last_m;
  }
  flown_m += (at - home).norm();
  EXPECT_NEAR(tour.total_m, flown_m, 1e-9 * flown_m);
  EXPECT_EQ(tour.total_m, best_directions_either_way(arcs, order, home, straight).total_m);
  std::ranges::sort(order);
  std::vector<std::uint32_t> all(arcs.size());
  std::iota(all.begin(), all.end(), 0U);
  EXPECT_EQ(order, all);
}

TEST_P(Rivals, FindNearlyTheShortestTourOfAFewArcs) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto arcs = random_arcs(7, seed);
    std::vector<std::uint32_t> order(arcs.size());
    std::iota(order.begin(), order.end(), 0U);
    double shortest_m = std::numeric_limits<double>::infinity();
    do shortest_m = std::min(shortest_m, best_directions(arcs, order, home, straight).total_m);
    while (std::ranges::next_permutation(order).found);
    EXPECT_LT(solved(GetParam(), arcs, 300, seed).tour.total_m, 1.01 * shortest_m)
        << "seed " << seed;
  }
}

TEST_P(Rivals, GetBetterWithTimeAndAreTheSameForASeed) {
  const auto arcs = random_arcs(40, 11);
  const double little_m = solved(GetParam(), arcs, 1).tour.total_m;
  const double much_m = solved(GetParam(), arcs, 100).tour.total_m;
  EXPECT_LT(much_m, 0.99 * little_m);
  EXPECT_EQ(solved(GetParam(), arcs, 100).tour.stops, solved(GetParam(), arcs, 100).tour.stops);
  EXPECT_NE(solved(GetParam(), arcs, 3, 1).tour.stops, solved(GetParam(), arcs, 3, 2).tour.stops);
}

TEST_P(Rivals, TakeNoneOneAndTwoArcs) {
  for (const std::size_t count : {0, 1, 2}) {
    const Tour tour = solved(GetParam(), random_arcs(count, 5), 3).tour;
    EXPECT_EQ(tour.stops.size(), count);
  }
}

INSTANTIATE_TEST_SUITE_P(All, Rivals, ::testing::Values(Rival::ga, Rival::aco, Rival::pso),
                         [](const auto& rival) {
                           return std::string(rival_names[static_cast<std::size_t>(rival.param)]);
                         });

}  // namespace
}  // namespace arcbid
