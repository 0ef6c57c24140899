// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/tour/tour.hpp"
#include "tests/tour/random_arcs.hpp"

namespace arcbid {
namespace {

/// Climbing and flying east against the wind cost extra.
class WindyTransit : public StraightTransit {
 public:
  double length_m(const Vec3& from, const Vec3& to) const override {
    const Vec3 d = to - from;
    return d.norm() + 2 * std::max(0.0, d.z()) + std::max(0.0, d.x());
  }
};

double connecting_m(const std::vector<TourArc>& arcs, const std::vector<Stop>& stops,
                    const Vec3& home_m, const Transit& transit) {
  double sum = 0;
  Vec3 here = home_m;
  for (const Stop& stop : stops) {
    const TourArc& arc = arcs[stop.arc];
    sum += transit.length_m(here, stop.reversed ? arc.last_m : arc.first_m);
    here = stop.reversed ? arc.first_m : arc.last_m;
  }
  return stops.empty() ? 0 : sum + transit.length_m(here, home_m);
}

/// All 2^m directions.
double shortest_by_trying_m(const std::vector<TourArc>& arcs,
                            const std::vector<std::uint32_t>& order, const Vec3& home_m,
                            const Transit& transit) {
  double best = std::numeric_limits<double>::infinity();
  for (std::uint32_t bits = 0; bits < 1U << order.size(); ++bits) {
    std::vector<Stop> stops;
    for (std::size_t k = 0; k < order.size(); ++k)
      stops.push_back({order[k], (bits >> k & 1U) == 1U});
    best = std::min(best, connecting_m(arcs, stops, home_m, transit));
  }
  return best;
}

void expect_exact(const Transit& transit) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const std::size_t count = 1 + seed % 9;
    const std::vector<TourArc> arcs = random_arcs(count, seed);
    std::vector<std::uint32_t> order(count);
    std::iota(order.rbegin(), order.rend(), 0U);
    const Vec3 home_m(50, 0, 0);
    const Tour tour = best_directions(arcs, order, home_m, transit);
    ASSERT_EQ(tour.stops.size(), count);
    for (std::size_t k = 0; k < count; ++k) EXPECT_EQ(tour.stops[k].arc, order[k]);
    EXPECT_NEAR(tour.connecting_m, connecting_m(arcs, tour.stops, home_m, transit), 1e-9);
    EXPECT_NEAR(tour.connecting_m, shortest_by_trying_m(arcs, order, home_m, transit), 1e-9)
        << "seed " << seed;
  }
}

TEST(BestDirections, EqualsAllDirectionsTriedSymmetric) {
  expect_exact(StraightTransit());
}

TEST(BestDirections, EqualsAllDirectionsTriedAsymmetric) {
  expect_exact(WindyTransit());
}

TEST(BestDirections, TotalIsTransitsAndArcs) {
  const std::vector<TourArc> arcs{{{1, 0, 0}, {3, 0, 0}, 5.0}, {{3, 4, 0}, {0, 4, 0}, 7.0}};
  const Tour tour =
      best_directions(arcs, std::vector<std::uint32_t>{0, 1}, Vec3::Zero(), StraightTransit());
  EXPECT_THAT(tour.stops, testing::ElementsAre(Stop{0, false}, Stop{1, false}));
  EXPECT_DOUBLE_EQ(tour.connecting_m, 1.0 + 4.0 + 4.0);
  EXPECT_DOUBLE_EQ(tour.total_m, 9.0 + 12.0);
}

TEST(BestDirections, TiesFlyForward) {
  const Vec3 home_m(0, 0, 0);
  const std::vector<TourArc> one{{{1, 1, 0}, {-1, 1, 0}, 2.0}};
  const std::vector<TourArc> loops{{{1, 0, 0}, {1, 0, 0}, 9.0}, {{2, 0, 0}, {2, 0, 0}, 9.0}};
  EXPECT_THAT(best_directions(one, std::vector<std::uint32_t>{0}, home_m, StraightTransit()).stops,
              testing::ElementsAre(Stop{0, false}));
  EXPECT_THAT(
      best_directions(loops, std::vector<std::uint32_t>{1, 0}, home_m, StraightTransit()).stops,
      testing::ElementsAre(Stop{1, false}, Stop{0, false}));
}

TEST(BestDirections, NothingToVisitStaysHome) {
  const Tour tour = best_directions({}, {}, Vec3(1, 2, 3), StraightTransit());
  EXPECT_TRUE(tour.stops.empty());
  EXPECT_EQ(tour.total_m, 0);
}

TEST(PlanTour, TakesTheSenseThatAnAsymmetricTransitFavours) {
  const WindyTransit windy;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const std::vector<TourArc> arcs = random_arcs(12, seed);
    const Vec3 home_m(50, 0, 0);
    std::vector<std::uint32_t> order = crsom_order(arcs, home_m, {});
    const double along_m = best_directions(arcs, order, home_m, windy).connecting_m;
    std::ranges::reverse(order);
    const double against_m = best_directions(arcs, order, home_m, windy).connecting_m;
    EXPECT_EQ(crsom_tour(arcs, home_m, windy, {}).connecting_m, std::min(along_m, against_m));
  }
}

}  // namespace
}  // namespace arcbid
