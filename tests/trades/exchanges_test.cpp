// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trades/exchanges.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <numeric>

#include "tests/trades/market.hpp"

namespace arcbid {
namespace {

using ::testing::Each;

Allocation result(const Market& market, const Transit& transit, TradesKind kind,
                  std::uint64_t seed = 1) {
  return exchanged(market.traders, market.lots, market.start, transit, kind, seed);
}

/// All orders, cuts and directions for two traders.
double optimum_s(const Market& market, const Transit& transit) {
  const std::size_t lots = market.lots.size();
  std::vector<std::uint32_t> order(lots);
  std::iota(order.begin(), order.end(), 0u);
  double best_s = HUGE_VAL;
  do {
    for (std::size_t cut = 0; cut <= lots; ++cut)
      for (std::uint32_t directions = 0; directions < 1u << lots; ++directions) {
        Allocation all(2);
        for (std::size_t k = 0; k < lots; ++k)
          all[k >= cut].push_back({order[k], (directions >> k & 1) != 0});
        best_s = std::min(best_s, plain_slowest_s(market, all, transit));
      }
  } while (std::next_permutation(order.begin(), order.end()));
  return best_s;
}

TEST(Exchanges, FindNearlyAlwaysTheBestAllocationOfAFewLots) {
  const StraightTransit straight;
  int best = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const Market market(seed, 2, 5);
    const double found_s =
        plain_slowest_s(market, result(market, straight, TradesKind::full), straight);
    const double least_s = optimum_s(market, straight);
    EXPECT_LE(found_s, 1.005 * least_s) << "seed " << seed;
    best += found_s <= least_s + 1e-9;
  }
  EXPECT_GE(best, 10);
}

TEST(Exchanges, LoseNothingAndAreNeverWorse) {
  const StraightTransit straight;
  const WindyTransit windy;
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Market market(seed, 1 + seed % 7, seed % 30);
    const Transit& transit = seed % 2 == 0 ? straight : static_cast<const Transit&>(windy);
    const Allocation after = result(market, transit, TradesKind::cheap);
    ASSERT_EQ(after.size(), market.traders.size());
    ASSERT_THAT(flown(after, market.lots.size()), Each(1u));
    EXPECT_LE(plain_slowest_s(market, after, transit),
              plain_slowest_s(market, market.start, transit) + 1e-9);
  }
}

TEST(Exchanges, KeepAnAllocationThatCannotBeBettered) {
  const StraightTransit straight;
  const Market market(5, 2, 5);
  Market best = market;
  best.start = result(market, straight, TradesKind::full);
  EXPECT_EQ(result(best, straight, TradesKind::full), best.start);
}

TEST(Exchanges, AreTheSameWhoeverWorksThemOut) {
  const StraightTransit straight;
  const Market market(9, 5, 60);
  const Allocation once = result(market, straight, TradesKind::cheap);
  EXPECT_EQ(result(market, straight, TradesKind::cheap), once);
  EXPECT_NE(result(market, straight, TradesKind::cheap, 2), once);
  EXPECT_NE(once, market.start);
}

TEST(Exchanges, OffChangesNothing) {
  const Market market(4, 3, 20);
  Exchanges exchanges(market.traders, market.lots, market.start, StraightTransit(), TradesKind::off,
                      1);
  EXPECT_TRUE(exchanges.done());
  EXPECT_EQ(exchanges.best(), market.start);
  EXPECT_EQ(exchanges.count(), 0u);
}

TEST(Exchanges, EndAfterAsManyStepsWhateverTheyFind) {
  const StraightTransit straight;
  const auto steps = [&](const Market& market) {
    Exchanges exchanges(market.traders, market.lots, market.start, straight, TradesKind::cheap, 1);
    int count = 0;
    for (; !exchanges.done(); ++count) exchanges.step();
    exchanges.step();
    EXPECT_TRUE(exchanges.done());
    return count;
  };
  EXPECT_EQ(steps(Market(1, 4, 30)), steps(Market(2, 4, 30)));
}

TEST(Exchanges, LevelFlightTimesAndNotLengths) {
  Market market(6, 2, 40);
  for (Trader& trader : market.traders) trader.home_m = Vec3(50, 50, 0);
  market.traders[0].speed_mps = 3;
  market.traders[1].speed_mps = 1;
  const StraightTransit straight;
  const auto times =
      times_s(market.traders, market.lots, result(market, straight, TradesKind::full), straight);
  EXPECT_NEAR(times[0] / times[1], 1, 0.05);
}

TEST(Exchanges, StandHomesFarAwayAndLotsInOnePlace) {
  Market market(8, 3, 12);
  for (Lot& lot : market.lots) lot = {Vec3(1, 2, 3), Vec3(1, 2, 3), 5};
  const StraightTransit straight;
  const Allocation after = result(market, straight, TradesKind::full);
  EXPECT_THAT(flown(after, 12), Each(1u));
  for (Trader& trader : market.traders) trader.home_m = Vec3(1, 2, 3);
  market.start = {{}, {}, {}};
  for (std::uint32_t lot = 0; lot < 12; ++lot) market.start[0].push_back({lot, false});
  for (Trader& trader : market.traders) trader.speed_mps = 1;
  EXPECT_DOUBLE_EQ(plain_slowest_s(market, result(market, straight, TradesKind::full), straight),
                   20);
}

}  // namespace
}  // namespace arcbid
