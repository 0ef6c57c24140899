// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <numbers>
#include <numeric>

#include "core/tour/ring.hpp"
#include "core/tour/tour.hpp"
#include "tests/tour/random_arcs.hpp"

namespace arcbid {
namespace {

std::vector<std::uint32_t> sorted(std::vector<std::uint32_t> order) {
  std::ranges::sort(order);
  return order;
}

std::vector<std::uint32_t> identity(std::size_t count) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0U);
  return order;
}

/// `count` arcs along a circle, given in the order `k * step` modulo `count`.
std::vector<TourArc> arcs_on_circle(std::uint32_t count, std::uint32_t step) {
  const auto at = [&](double k) {
    const double angle = 2 * std::numbers::pi * k / count;
    return Vec3(100 * std::cos(angle), 100 * std::sin(angle), 7);
  };
  std::vector<TourArc> arcs;
  for (std::uint32_t k = 0; k < count; ++k) {
    const double place = k * step % count;
    arcs.push_back({at(place), at(place + 0.5), (at(place) - at(place + 0.5)).norm()});
  }
  return arcs;
}

TEST(GrowingRing, ANewNeuronComesBesideTheOneThatWinsMost) {
  GrowingRing ring(4, Vec3::Zero(), 1.0);  // neurons at (1,0,0) (0,1,0) (-1,0,0) (0,-1,0)
  const Vec3 east(1, 0, 0), off_north(0.2, 1, 0);
  EXPECT_EQ(ring.winner(east), 0U);
  ring.pull(0, east, 0.5, 0.01);
  ring.pull(1, off_north, 1.0, 0.01);
  ring.pull(1, off_north, 1.0, 0.01);
  ring.grow();
  EXPECT_EQ(ring.size(), 5U);
  EXPECT_EQ(ring.winner(Vec3(-0.4, 0.5, 0)), 2U);  // half-way to the successor, the farther one
  EXPECT_EQ(ring.winner(Vec3(-1, 0, 0)), 3U);
}

TEST(GrowingRing, NeighboursFollowByTheGaussianOfTheirDistance) {
  GrowingRing ring(8, Vec3::Zero(), 1.0);
  const Vec3 target(10, 0, 0);
  ring.pull(0, target, 0.5, 1.0);
  // x of neuron 1 was cos 45 deg; it moved by eta exp(-1/2) of the way. Found as the winner there.
  const double before = std::cos(std::numbers::pi / 4);
  const double moved = 0.5 * std::exp(-0.5);
  const Vec3 expected(before + moved * (10 - before), before * (1 - moved), 0);
  EXPECT_EQ(ring.winner(expected), 1U);
  EXPECT_EQ(ring.winner(Vec3(expected.x(), -expected.y(), 0)), 7U);
  EXPECT_EQ(ring.winner(Vec3(5.5, 0, 0)), 0U);
}

TEST(CrsomOrder, IsAPermutation) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const auto arcs = random_arcs(seed, seed);
    EXPECT_EQ(sorted(crsom_order(arcs, Vec3::Zero(), {.seed = seed, .epochs = 20})),
              identity(seed));
  }
}

TEST(CrsomOrder, SameSeedSameOrder) {
  const auto arcs = random_arcs(60, 3);
  const TourSettings settings{.seed = 42, .epochs = 50};
  const auto first = crsom_order(arcs, Vec3::Zero(), settings);
  EXPECT_EQ(crsom_order(arcs, Vec3::Zero(), settings), first);
  EXPECT_NE(crsom_order(arcs, Vec3::Zero(), {.seed = 43, .epochs = 50}), first);
}

TEST(CrsomOrder, FollowsACircleFromHome) {
  const Vec3 home_m(100 * std::cos(-0.05), 100 * std::sin(-0.05), 7);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto arcs = arcs_on_circle(25, 7);
    std::vector<std::uint32_t> places;
    for (const auto arc : crsom_order(arcs, home_m, {.seed = seed, .epochs = 100}))
      places.push_back(arc * 7 % 25);
    if (places.front() != 0) std::ranges::reverse(places);
    EXPECT_EQ(places, identity(25)) << "seed " << seed;
  }
}

TEST(CrsomOrder, UnitsDoNotMatter) {
  auto arcs = random_arcs(40, 9);
  const auto order = crsom_order(arcs, Vec3::Zero(), {});
  for (TourArc& arc : arcs) {  // a power of two scales without rounding
    arc.first_m *= 1024;
    arc.last_m *= 1024;
  }
  EXPECT_EQ(crsom_order(arcs, Vec3::Zero(), {}), order);
}

TEST(CrsomOrder, FewArcsAndCoincidentPointsAreOrdinary) {
  const Vec3 home_m(1, 2, 3);
  const TourArc loop{home_m, home_m, 4.0};
  EXPECT_TRUE(crsom_order({}, home_m, {}).empty());
  for (std::size_t count = 1; count <= 12; ++count)
    EXPECT_EQ(crsom_order(std::vector<TourArc>(count, loop), home_m, {}), identity(count));
  const std::vector<TourArc> same(9, TourArc{{9, 9, 9}, {9, 9, 8}, 1.0});
  EXPECT_EQ(sorted(crsom_order(same, home_m, {})), identity(9));
}

TEST(CrsomOrder, NoEpochsOrBrokenCoordinatesStillGiveAPermutation) {
  auto arcs = random_arcs(10, 1);
  EXPECT_EQ(sorted(crsom_order(arcs, Vec3::Zero(), {.seed = 1, .epochs = 0})), identity(10));
  EXPECT_EQ(sorted(crsom_order(arcs, Vec3::Zero(), {.seed = 1, .epochs = 1})), identity(10));
  arcs[4].last_m.y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(crsom_order(arcs, Vec3::Zero(), {}), identity(10));
  arcs[4].last_m.y() = std::numeric_limits<double>::infinity();
  EXPECT_EQ(crsom_order(arcs, Vec3::Zero(), {}), identity(10));
}

TEST(PlanTour, FewArcs) {
  const StraightTransit straight;
  EXPECT_EQ(plan_tour({}, Vec3::Zero(), straight, {}).total_m, 0);
  const std::vector<TourArc> two{{{1, 0, 0}, {0, 1, 0}, 2.0}, {{2, 2, 0}, {1, 0, 0}, 3.0}};
  const Tour one = plan_tour(std::span(two).first(1), Vec3::Zero(), straight, {});
  EXPECT_DOUBLE_EQ(one.total_m, 4.0);
  const Tour both = plan_tour(two, Vec3::Zero(), straight, {});
  EXPECT_NEAR(both.connecting_m, 1 + std::sqrt(8.0), 1e-12);
  EXPECT_EQ(both.stops.size(), 2U);
}

TEST(PlanTour, AThousandArcsInWellUnderASecond) {
  const auto arcs = random_arcs(1000, 5);
  const std::clock_t start = std::clock();  // CPU time: other tests may run at the same time
  const Tour tour = plan_tour(arcs, Vec3::Zero(), StraightTransit(), {});
  const double took_s = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  std::vector<std::uint32_t> visited;
  for (const Stop& stop : tour.stops) visited.push_back(stop.arc);
  EXPECT_EQ(sorted(visited), identity(1000));
  RecordProperty("cpu_seconds", std::to_string(took_s));
// Debug and sanitised builds say nothing about speed.
#if defined(NDEBUG) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  EXPECT_LT(took_s, 2.0);
#endif
}

}  // namespace
}  // namespace arcbid
