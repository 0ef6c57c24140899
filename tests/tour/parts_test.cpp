// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the local search, each against the plain way to do the same.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "core/tour/cycle.hpp"
#include "core/tour/greedy.hpp"
#include "core/tour/kd_tree.hpp"
#include "core/tour/neighbours.hpp"
#include "tests/tour/random_arcs.hpp"

namespace arcbid {
namespace {

const StraightTransit straight;

/// Flying east costs extra, and the farther north the more.
class ShearTransit : public Transit {
 public:
  double length_m(const Vec3& from, const Vec3& to) const override {
    const Vec3 d = to - from;
    return d.norm() + std::max(0.0, d.x()) * (1 + 0.01 * from.y());
  }
  std::vector<Vec3> way(const Vec3& from, const Vec3& to) const override { return {from, to}; }
};

std::vector<std::uint32_t> all_nodes(const TourCosts& costs) {
  std::vector<std::uint32_t> nodes(costs.nodes());
  std::iota(nodes.begin(), nodes.end(), 0U);
  return nodes;
}

TEST(TourCosts, AreTheTransitsFromATableAndWithout) {
  const auto arcs = random_arcs(9, 3);
  const Vec3 home_m(1, 2, 3);
  const ShearTransit shear;
  const TourCosts plain(arcs, home_m, straight), table(arcs, home_m, shear),
      asked(arcs, home_m, shear, 0);
  ASSERT_EQ(plain.nodes(), 20U);
  EXPECT_TRUE(plain.is_symmetric());
  EXPECT_FALSE(table.is_symmetric());
  EXPECT_FALSE(asked.is_symmetric());
  for (std::uint32_t u = 0; u < 20; ++u)
    for (std::uint32_t v = 0; v < 20; ++v) {
      const Vec3 &a = plain.points()[u], &b = plain.points()[v];
      EXPECT_NEAR(plain.directed(u, v), (a - b).norm(), 1e-12);
      EXPECT_EQ(table.directed(u, v), shear.length_m(a, b));
      EXPECT_EQ(asked.directed(u, v), shear.length_m(a, b));
      EXPECT_NEAR(table.mean(u, v) + table.excess(u, v), table.directed(u, v), 1e-12);
    }
}

TEST(KdTree, FindsTheNearestOfEveryOctant) {
  std::mt19937 random(5);
  std::vector<Vec3> points;
  for (int n = 0; n < 300; ++n)  // on a coarse grid, so that many tie or share a coordinate
    points.emplace_back(random() % 12, random() % 12, n % 2 == 0 ? 3.0 : random() % 5);
  std::vector<std::uint32_t> chosen;
  for (std::uint32_t n = 0; n < 300; ++n)
    if (n % 3 != 0) chosen.push_back(n);
  const KdTree tree(points, chosen);
  for (std::uint32_t from = 0; from < 300; ++from)
    for (unsigned octant = 0; octant <= KdTree::everywhere; ++octant) {
      std::vector<double> expected;
      for (const std::uint32_t other : chosen) {
        const Vec3 away = points[other] - points[from];
        unsigned in = 0;
        for (unsigned a = 0; a < 3; ++a) in |= away[a] >= 0 ? 1U << a : 0U;
        if (other / 2 != from / 2 && (octant == KdTree::everywhere || octant == in))
          expected.push_back(away.squaredNorm());
      }
      std::ranges::sort(expected);
      std::array<KdTree::Found, 3> found;
      tree.nearest(from, points[from], octant, found);
      for (std::size_t n = 0; n < found.size(); ++n) {
        ASSERT_EQ(found[n].point == UINT32_MAX, n >= expected.size());
        if (n < expected.size()) {
          ASSERT_EQ(found[n].squared_m, expected[n]);
        }
      }
    }
}

TEST(Neighbours, LeadOutOfACluster) {
  std::vector<TourArc> arcs;
  for (int n = 0; n < 20; ++n) arcs.push_back({{0.1 * n, 0, 0}, {0.1 * n, 0.05, 0}, 0.05});
  arcs.push_back({{100, 1, 0}, {101, 1, 0}, 1});
  const TourCosts costs(arcs, Vec3::Zero(), straight);
  const Neighbours neighbours(costs, all_nodes(costs));
  bool leads_out = false;
  for (std::uint32_t node = 0; node < 40; ++node) {
    const auto near = neighbours.of(node);
    EXPECT_TRUE(std::ranges::is_sorted(near, {}, &Neighbour::cost));
    for (const Neighbour& next : near) {
      EXPECT_NE(next.node / 2, node / 2);
      EXPECT_EQ(next.cost, costs.mean(node, next.node));
      leads_out = leads_out || next.node / 2 == 20;
    }
  }
  EXPECT_TRUE(leads_out);
}

TEST(GreedyEntries, VisitEveryArcOnceAndTakeTheObviousLegs) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const auto arcs = random_arcs(2 + 7 * seed, seed);
    const TourCosts costs(arcs, Vec3::Zero(), straight);
    auto entries = greedy_entries(costs, Neighbours(costs, all_nodes(costs)));
    for (std::uint32_t& entry : entries) entry /= 2;
    std::ranges::sort(entries);
    ASSERT_EQ(entries.size(), arcs.size() + 1);
    for (std::uint32_t n = 0; n < entries.size(); ++n) ASSERT_EQ(entries[n], n);
  }
  std::vector<TourArc> row;
  for (int n = 0; n < 12; ++n) row.push_back({{2.0 * n, 0, 0}, {2.0 * n + 1.5, 0, 0}, 1.5});
  const TourCosts costs(row, Vec3(-1, 0, 0), straight);
  const Cycle cycle(costs, greedy_entries(costs, Neighbours(costs, all_nodes(costs))));
  EXPECT_NEAR(cycle.cost(), 11 * 0.5 + 1 + 24.5, 1e-9);
}

/// The cheaper sense of travel of a cycle, summed leg by leg.
double cost_of(const TourCosts& costs, const std::vector<std::uint32_t>& entries) {
  double along = 0, against = 0;
  for (std::size_t n = 0; n < entries.size(); ++n) {
    const std::uint32_t exit = entries[n] ^ 1U, next = entries[(n + 1) % entries.size()];
    along += costs.directed(exit, next);
    against += costs.directed(next, exit);
  }
  return std::min(along, against);
}

template <class T>
void shuffle(std::vector<T>& list, std::mt19937& random) {
  for (std::size_t n = list.size(); n > 1; --n) std::swap(list[n - 1], list[random() % n]);
}

/// A random exchange of `legs` distinct legs: any way to join their ends, closing or not.
Exchange random_exchange(const Cycle& cycle, std::size_t legs, std::mt19937& random) {
  std::vector<std::uint32_t> gaps(cycle.arcs());
  std::iota(gaps.begin(), gaps.end(), 0U);
  shuffle(gaps, random);
  Exchange out{.legs = legs, .ends = {}, .joined = {}};
  std::vector<std::uint8_t> ends;
  for (std::size_t n = 0; n < legs; ++n) {
    const std::uint32_t exit = cycle.entries()[gaps[n]] ^ 1U;
    const bool turned = random() % 2 == 0;
    out.ends[2 * n + turned] = exit;
    out.ends[2 * n + 1 - turned] = cycle.partner(exit);
    ends.push_back(static_cast<std::uint8_t>(2 * n));
    ends.push_back(static_cast<std::uint8_t>(2 * n + 1));
  }
  shuffle(ends, random);
  for (std::size_t n = 0; n < ends.size(); n += 2) {
    out.joined[ends[n]] = ends[n + 1];
    out.joined[ends[n + 1]] = ends[n];
  }
  return out;
}

/// Whether following arcs and legs in turn, without any array of positions, visits all.
bool is_one_tour(const Cycle& cycle, const Exchange& exchange) {
  std::vector<std::uint32_t> partner(2 * cycle.arcs());
  for (std::uint32_t node = 0; node < partner.size(); ++node) partner[node] = cycle.partner(node);
  for (std::size_t end = 0; end < 2 * exchange.legs; ++end)
    partner[exchange.ends[end]] = exchange.ends[exchange.joined[end]];
  std::uint32_t node = 0, visited = 0;
  do {
    node = partner[node ^ 1U];
    ++visited;
  } while (node != 0 && visited <= cycle.arcs());
  return visited == cycle.arcs();
}

void exchange_at_random(const Transit& transit) {
  std::mt19937 random(11);
  const auto arcs = random_arcs(16, 2);
  const TourCosts costs(arcs, Vec3(3, 4, 5), transit);
  Cycle cycle(costs, greedy_entries(costs, Neighbours(costs, all_nodes(costs))));
  std::size_t made = 0;
  for (int round = 0; round < 400; ++round) {
    const std::vector<std::uint32_t> before = cycle.entries();
    for (int n = 0; n < 5; ++n) {
      const Exchange exchange = random_exchange(cycle, 2 + random() % 4, random);
      const bool closes = cycle.closes(exchange);
      ASSERT_EQ(closes, is_one_tour(cycle, exchange));
      if (!closes) continue;
      double legs = 0;
      for (std::size_t end = 0; end < 2 * exchange.legs; ++end)
        legs += 0.5 * (costs.mean(exchange.ends[end], exchange.ends[exchange.joined[end]]) -
                       cycle.leg(exchange.ends[end]));
      const double expected = cycle.cost() + legs - cycle.saved();
      cycle.make(exchange);
      ++made;
      ASSERT_NEAR(cycle.cost(), expected, 1e-9);
      ASSERT_NEAR(cycle.cost(), cost_of(costs, cycle.entries()), 1e-9);
    }
    if (round % 2 == 0) {
      cycle.take_back();
      ASSERT_EQ(cycle.entries(), before);
      ASSERT_NEAR(cycle.cost(), cost_of(costs, before), 1e-9);
    } else {
      cycle.keep();
    }
  }
  EXPECT_GT(made, 500U);
}

TEST(Cycle, ExchangesAndTakesBackWhatItSays) {
  exchange_at_random(straight);
}

TEST(Cycle, ExchangesAndTakesBackWhatItSaysWhereCostsAreAsymmetric) {
  exchange_at_random(ShearTransit());
}

}  // namespace
}  // namespace arcbid
