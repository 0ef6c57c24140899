// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tour/search.hpp"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "tests/tour/random_arcs.hpp"

namespace arcbid {
namespace {

const StraightTransit straight;

/// Climbing and flying east against the wind cost extra.
class WindyTransit : public Transit {
 public:
  double length_m(const Vec3& from, const Vec3& to) const override {
    const Vec3 d = to - from;
    return d.norm() + 2 * std::max(0.0, d.z()) + std::max(0.0, d.x());
  }
  std::vector<Vec3> way(const Vec3& from, const Vec3& to) const override { return {from, to}; }
};

/// One-way streets around a roundabout: what is saved one way is lost the other, and it matters in
/// which sense a tour goes around.
class Roundabout : public WindyTransit {
 public:
  double length_m(const Vec3& from, const Vec3& to) const override {
    const Vec3 centre(50, 50, 50);
    const double turned = (from - centre).cross(to - centre).z();
    return (to - from).norm() * (turned < 0 ? 2.5 : 1);
  }
};

double shortest_by_trying_m(const std::vector<TourArc>& arcs, const Vec3& home_m,
                            const Transit& transit) {
  std::vector<std::uint32_t> order(arcs.size());
  std::iota(order.begin(), order.end(), 0U);
  double best = std::numeric_limits<double>::infinity();
  do best = std::min(best, best_directions(arcs, order, home_m, transit).total_m);
  while (std::ranges::next_permutation(order).found);
  return best;
}

std::vector<std::uint32_t> visited(const Tour& tour) {
  std::vector<std::uint32_t> arcs;
  for (const Stop& stop : tour.stops) arcs.push_back(stop.arc);
  std::ranges::sort(arcs);
  return arcs;
}

std::vector<std::uint32_t> all_of(std::size_t count) {
  std::vector<std::uint32_t> arcs(count);
  std::iota(arcs.begin(), arcs.end(), 0U);
  return arcs;
}

void expect_shortest(const Transit& transit, std::uint32_t iterations) {
  const Vec3 home_m(50, 0, 0);
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const std::vector<TourArc> arcs = random_arcs(2 + seed % 6, seed);
    TourSearch search(arcs, home_m, transit, seed);
    search.improve(iterations);
    const Tour tour = search.tour();
    EXPECT_EQ(visited(tour), all_of(arcs.size()));
    EXPECT_NEAR(tour.total_m, shortest_by_trying_m(arcs, home_m, transit), 1e-9)
        << arcs.size() << " arcs, seed " << seed;
  }
}

TEST(TourSearch, EqualsAllToursTriedStraight) {
  expect_shortest(straight, 60);
}

TEST(TourSearch, EqualsAllToursTriedInWind) {
  expect_shortest(WindyTransit(), 60);
}

TEST(TourSearch, EqualsAllToursTriedOnARoundabout) {
  expect_shortest(Roundabout(), 60);
}

TEST(TourSearch, MoreIterationsNeverMakeItLonger) {
  const std::vector<TourArc> arcs = random_arcs(80, 4);
  TourSearch search(arcs, Vec3::Zero(), straight, 1);
  const double first_m = search.tour().total_m;
  double last_m = first_m;
  for (int step = 0; step < 30; ++step) {
    search.improve(50);
    const double now_m = search.tour().total_m;
    EXPECT_LE(now_m, last_m + 1e-9);
    last_m = now_m;
  }
  EXPECT_LT(last_m, 0.99 * first_m);
}

TEST(TourSearch, StepsDoNotMatterAndSeedsDo) {
  const std::vector<TourArc> arcs = random_arcs(150, 6);
  const auto after = [&](std::uint64_t seed, std::uint32_t steps, std::uint32_t iterations) {
    TourSearch search(arcs, Vec3::Zero(), straight, seed);
    for (std::uint32_t n = 0; n < steps; ++n) search.improve(iterations);
    return search.tour().stops;
  };
  EXPECT_EQ(after(3, 1, 200), after(3, 20, 10));
  EXPECT_NE(after(3, 1, 200), after(4, 1, 200));
}

TEST(TourSearch, GoesOnFromAShorterTourThatIsOffered) {
  const std::vector<TourArc> arcs = random_arcs(120, 8);
  TourSearch thorough(arcs, Vec3::Zero(), straight, 1);
  thorough.improve(3000);
  const Tour good = thorough.tour();
  TourSearch search(arcs, Vec3::Zero(), straight, 2);
  EXPECT_GT(search.tour().total_m, good.total_m + 1e-6);
  search.offer(good);
  EXPECT_NEAR(search.tour().total_m, good.total_m, 1e-9);
  search.offer(best_directions(arcs, all_of(120), Vec3::Zero(), straight));
  EXPECT_NEAR(search.tour().total_m, good.total_m, 1e-9);
}

TEST(TourSearch, FewArcsAreOrdinary) {
  const Vec3 home_m(1, 2, 3);
  for (std::size_t count = 0; count <= 4; ++count) {
    const std::vector<TourArc> arcs = random_arcs(count, 5);
    TourSearch search(arcs, home_m, straight, 1);
    search.improve(20);
    EXPECT_EQ(visited(search.tour()), all_of(count));
  }
}

TEST(TourSearch, CoincidentAndCollinearPointsAreOrdinary) {
  const std::vector<TourArc> same(9, TourArc{{9, 9, 9}, {9, 9, 9}, 1.0});
  TourSearch on_one_spot(same, Vec3(9, 9, 9), straight, 1);
  on_one_spot.improve(50);
  EXPECT_EQ(visited(on_one_spot.tour()), all_of(9));
  EXPECT_EQ(on_one_spot.tour().connecting_m, 0);

  std::vector<TourArc> along;
  for (int n = 0; n < 40; ++n) {
    const double x = 3.0 * (n * 17 % 40) + 1;
    along.push_back({{x, 0, 0}, {x + 1, 0, 0}, 1.0});
  }
  TourSearch line(along, Vec3::Zero(), straight, 1);
  line.improve(200);
  EXPECT_NEAR(line.tour().total_m, 2 * 119.0, 1e-9);  // out and back, flying each arc once
}

TEST(TourSearch, WhereACoordinateIsNotFiniteTheOrderGivenStands) {
  std::vector<TourArc> arcs = random_arcs(10, 1);
  arcs[4].last_m.y() = std::numeric_limits<double>::quiet_NaN();
  TourSearch search(arcs, Vec3::Zero(), straight, 1);
  search.improve(10);
  EXPECT_EQ(visited(search.tour()), all_of(10));
}

TEST(ImprovedTour, IsNeverLongerThanItsStarts) {
  for (const TourSolver solver : {TourSolver::crsom, TourSolver::crsom_ls})
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const std::vector<TourArc> arcs = random_arcs(seed, seed);
      const TourSettings settings{.solver = solver, .seed = seed, .epochs = 5, .iterations = 3};
      const Tour crsom = crsom_tour(arcs, Vec3::Zero(), straight, settings);
      const Tour given = best_directions(arcs, all_of(seed), Vec3::Zero(), straight);
      const Tour best =
          improved_tour(arcs, Vec3::Zero(), straight, std::vector{given, crsom}, settings);
      EXPECT_LE(best.total_m, std::min(crsom.total_m, given.total_m));
      if (solver == TourSolver::crsom) {
        EXPECT_EQ(best.total_m, std::min(crsom.total_m, given.total_m));
      }
    }
}

TEST(PlanTour, SearchesAsLongAsItIsToldTo) {
  const std::vector<TourArc> arcs = random_arcs(100, 2);
  const auto planned_m = [&](TourSolver solver, std::uint32_t iterations) {
    return plan_tour(arcs, Vec3::Zero(), straight,
                     {.solver = solver, .seed = 1, .epochs = 30, .iterations = iterations})
        .total_m;
  };
  EXPECT_EQ(planned_m(TourSolver::crsom, 1000), planned_m(TourSolver::crsom, 0));
  EXPECT_LT(planned_m(TourSolver::crsom_ls, 0), planned_m(TourSolver::crsom, 0));
  EXPECT_LT(planned_m(TourSolver::crsom_ls, 1000), planned_m(TourSolver::crsom_ls, 0));
}

}  // namespace
}  // namespace arcbid
