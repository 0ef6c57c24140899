// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trades/changes.hpp"

#include <gmock/gmock.h>

#include "tests/trades/market.hpp"

namespace arcbid {
namespace {

using ::testing::Each;

std::optional<Change> any_change(const Tours& tours, Market& market) {
  const auto lots = static_cast<std::uint32_t>(market.lots.size());
  Wish wish{market.below(2 * lots), market.below(2 * (lots + market.traders.size()))};
  if (wish.one / 2 == wish.other / 2) return {};
  const std::uint32_t more = market.below(3), more_back = market.below(3);
  const std::uint32_t kind = market.below(3);
  if (kind == 0) return move_lots(tours, wish, more);
  if (kind == 1) return swap_lots(tours, wish, more, more_back, market.below(2) == 1);
  return cross(tours, wish);
}

/// Metres of each, the plain way.
std::vector<double> lengths_m(const Market& market, const Allocation& allocation) {
  std::vector<Trader> slow = market.traders;
  for (Trader& trader : slow) trader.speed_mps = 1;
  return times_s(slow, market.lots, allocation, StraightTransit());
}

TEST(Changes, CostWhatTheySayAndLoseNothing) {
  std::size_t of_one = 0, of_two = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Market market(seed, 1 + seed % 4, 1 + seed % 9);
    const Legs legs(market.traders, market.lots, StraightTransit(), 8);
    Tours tours(market.lots, legs, market.start);
    for (int n = 0; n < 200; ++n) {
      const auto change = any_change(tours, market);
      if (!change) continue;
      std::vector<double> expected_m = lengths_m(market, tours.allocation());
      expected_m[change->a] = change->length_a_m;
      if (change->b != Change::none) expected_m[change->b] = change->length_b_m;
      (change->b == Change::none ? of_one : of_two) += 1;
      tours.apply(*change);
      const Allocation after = tours.allocation();
      ASSERT_THAT(flown(after, market.lots.size()), Each(1u));
      const auto got_m = lengths_m(market, after);
      for (std::uint32_t a = 0; a < tours.count(); ++a) {
        ASSERT_NEAR(got_m[a], expected_m[a], 1e-3);  // legs are kept in floats
        ASSERT_NEAR(tours.length_m(a), expected_m[a], 1e-3);
      }
    }
  }
  EXPECT_GT(of_one, 2000u);
  EXPECT_GT(of_two, 2000u);
}

TEST(Changes, BringTogetherWhatWasWishedFor) {
  Market market(7, 3, 12);
  const Legs legs(market.traders, market.lots, StraightTransit(), 8);
  for (int n = 0; n < 3000; ++n) {
    Tours tours(market.lots, legs, market.start);
    const Wish wish{market.below(24), market.below(24)};
    if (wish.one / 2 == wish.other / 2) continue;
    const auto change = n % 2 == 0 ? move_lots(tours, wish, market.below(2)) : cross(tours, wish);
    if (!change) continue;
    tours.apply(*change);
    const std::uint32_t lot = wish.one / 2, other = wish.other / 2;
    ASSERT_EQ(tours.owner(lot), tours.owner(other));
    const bool entered = tours.at(tours.owner(lot), tours.position(lot)) == wish.one;
    ASSERT_EQ(tours.position(other), tours.position(lot) + (entered ? -1 : 1));
    ASSERT_EQ(tours.at(tours.owner(lot), tours.position(other)) == wish.other, !entered);
  }
}

TEST(Legs, AreLeveledAndTheNearestComeFirst) {
  Market market(3, 2, 20);
  const WindyTransit windy;
  const Legs legs(market.traders, market.lots, windy, 5);
  const auto at = [&](Node node) {
    return node % 2 == 0 ? market.lots[node / 2].first_m : market.lots[node / 2].last_m;
  };
  for (Node a = 0; a < 40; ++a) {
    ASSERT_EQ(legs.near(a).size(), 5u);
    std::size_t nearer = 0;
    for (Node b = 0; b < 40; ++b) {
      const double mean_m = 0.5 * (windy.length_m(at(a), at(b)) + windy.length_m(at(b), at(a)));
      ASSERT_NEAR(legs.length_m(a, b), mean_m, 1e-4);
      nearer += a / 2 != b / 2 && legs.length_m(a, b) < legs.length_m(a, legs.near(a).back());
    }
    EXPECT_EQ(nearer, 4u);
  }
}

}  // namespace
}  // namespace arcbid
