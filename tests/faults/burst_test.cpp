// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/faults/burst_chain.hpp"
#include "tests/faults/link_fixture.hpp"

namespace arcbid {
namespace {

constexpr std::uint64_t many = 400'000;

LinkFault bursts(const Burst& burst) {
  LinkFault fault;
  fault.burst = burst;
  return fault;
}

TEST(Burst, MeanLossAndLengthAreTheStatedOnes) {
  for (const Burst& burst : {Burst{0.3, 8, 0, 1}, Burst{0.1, 20, 0, 1}, Burst{0.6, 3, 0, 1}}) {
    const std::vector<bool> lost = losses(link(with(bursts(burst))), many);
    EXPECT_NEAR(share(lost), burst.mean_loss, 0.01);
    EXPECT_NEAR(mean_run(lost), burst.mean_length, 0.03 * burst.mean_length);
  }
}

TEST(Burst, PartialLossInBothStatesKeepsTheMean) {
  EXPECT_NEAR(share(losses(link(with(bursts({0.3, 8, 0.05, 0.8}))), many)), 0.3, 0.01);
}

TEST(Burst, TheStateLastsAsLongAsStatedUnderPartialLoss) {
  BurstChain chain({0.3, 8, 0.05, 0.8}, Chance(3, 0, {1}, {2}));
  std::vector<bool> bad;
  for (std::uint64_t n = 0; n < many; ++n) bad.push_back(chain.is_bad(n));
  EXPECT_NEAR(mean_run(bad), 8, 0.2);
  EXPECT_NEAR(share(bad), (0.3 - 0.05) / (0.8 - 0.05), 0.01);
}

TEST(Burst, OneMessageAtATimeNeverLosesTwoInARow) {
  const std::vector<bool> lost = losses(link(with(bursts({0.3, 1, 0, 1}))), many);
  EXPECT_NEAR(share(lost), 0.3, 0.01);
  EXPECT_EQ(mean_run(lost), 1);
}

TEST(Burst, SameMeanAsIndependentLossButLongerRuns) {
  LinkFault independent;
  independent.loss = 0.3;
  const std::vector<bool> single = losses(link(with(independent)), many),
                          burst = losses(link(with(bursts({0.3, 8, 0, 1}))), many);
  EXPECT_NEAR(share(single), share(burst), 0.01);
  EXPECT_NEAR(mean_run(single), 1 / 0.7, 0.03);  // runs of independent losses are geometric
  EXPECT_GT(mean_run(burst), 5 * mean_run(single));
}

/// Chains whose bad states seek and avoid each other, and one that alternates.
class BurstState : public testing::TestWithParam<Burst> {};
INSTANTIATE_TEST_SUITE_P(All, BurstState,
                         testing::Values(Burst{0.3, 8, 0, 1}, Burst{0.2, 500, 0, 1},
                                         Burst{0.45, 1, 0, 1}, Burst{0.5, 1, 0, 1},
                                         Burst{0, 8, 0, 1}));

TEST_P(BurstState, IsAFunctionOfTheSequenceNumberHoweverItIsReached) {
  const Chance chance(5, 0, {1}, {2});
  BurstChain forward(GetParam(), chance);
  std::vector<bool> bad;
  for (std::uint64_t n = 0; n < 3000; ++n) bad.push_back(forward.is_bad(n));
  for (std::uint64_t n = 0; n < 3000; n += 97)
    EXPECT_EQ(BurstChain(GetParam(), chance).is_bad(n), bad[n]) << n;
  BurstChain jumping(GetParam(), chance);
  for (std::uint64_t i = 0, n = 0; i < 500; ++i, n = (n + 1237) % 3000)
    EXPECT_EQ(jumping.is_bad(n), bad[n]) << n;
}

TEST_P(BurstState, IsFoundFarAwayAndAcrossAnAnchor) {
  const Chance chance(5, 0, {1}, {2});
  const std::uint64_t anchor = 1U << 20;
  BurstChain forward(GetParam(), chance);
  std::vector<bool> bad;
  for (std::uint64_t n = anchor - 20; n < anchor + 20; ++n) bad.push_back(forward.is_bad(n));
  for (std::uint64_t i = 0; i < 40; ++i)
    EXPECT_EQ(BurstChain(GetParam(), chance).is_bad(anchor - 20 + i), bad[i]);
  BurstChain(GetParam(), chance).is_bad(UINT64_MAX);
}

TEST(Burst, NoLossMeansNone) {
  EXPECT_EQ(share(losses(link(with(bursts({0, 8, 0, 1}))), 10'000)), 0);
}

}  // namespace
}  // namespace arcbid
