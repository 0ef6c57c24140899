// SPDX-License-Identifier: GPL-3.0-or-later
// Whole worlds: what is shipped as configs/sim.yaml, and what the other policies do not survive.
#include <gtest/gtest.h>

#include <thread>

#include "sim/world/batch.hpp"
#include "sim/world/settings_file.hpp"

namespace arcbid::testing {
namespace {

const std::filesystem::path configs = std::filesystem::path(ARCBID_SOURCE_DIR) / "configs";

std::string text(const WorldResult& result) {
  std::string out;
  for (const Violation& v : result.violations)
    out += fmt::format("seed {}: {}: {}\n", result.seed, v.checker, v.what);
  return out;
}

TEST(Worlds, TwoThousandOfEveryKindPass) {
  WorldSettings settings = load_worlds(configs / "sim.yaml");
  settings.price = false;
  std::uint64_t worlds = 0;
  run_batch(settings, 1, 2000, 2, [&](const PricedResult& result) {
    EXPECT_TRUE(result.world.agreed && result.world.violations.empty()) << text(result.world);
    return ++worlds < 2000;
  });
  EXPECT_EQ(worlds, 2000u);
}

TEST(Worlds, RepeatBitForBitWhateverTheNumberOfThreads) {
  const WorldSettings settings = load_worlds(configs / "sim.yaml");
  const auto digests = [&](unsigned jobs) {
    std::vector<std::uint64_t> out;
    run_batch(settings, 500, 560, jobs, [&](const PricedResult& result) {
      out.push_back(result.world.digest);
      out.push_back(result.fault_free->digest);
      return true;
    });
    return out;
  };
  const auto alone = digests(1);
  EXPECT_EQ(alone.size(), 122u);
  EXPECT_EQ(digests(3), alone);
}

TEST(Worlds, DifferByTheirSeeds) {
  const WorldSettings settings = load_worlds(configs / "sim.yaml");
  EXPECT_NE(run_priced(settings, 1).world.digest, run_priced(settings, 2).world.digest);
}

TEST(Worlds, DoNotPassWhereBidsAreNotWarped) {
  WorldSettings settings = load_worlds(configs / "sim.yaml");
  settings.scores = {ScoreKind::discounted_insert};
  settings.layouts = {Layout::grid};
  settings.odds = {};
  settings.price = false;
  std::uint64_t cycling = 0;
  run_batch(settings, 1, 600, 2, [&](const PricedResult& result) {
    cycling += !result.world.agreed;
    return cycling == 0;
  });
  EXPECT_GT(cycling, 0u) << "insertion without warping is known to cycle";
}

/// Seed 1 of worlds in which nothing happens but that somebody bids over everybody.
WorldSpec over_bid_world(PolicyKind policy, bool audited) {
  WorldSettings settings = load_worlds(configs / "sim.yaml");
  settings.policies = {policy};
  settings.topologies = {TopologyKind::complete};
  settings.odds = {};
  settings.odds[static_cast<std::size_t>(WorldFault::over_bid)] = 1;
  settings.agents = {4, 6};
  WorldSpec spec = make_world(settings, 1);
  spec.mission.auction.audit_bids = audited;
  return spec;
}

TEST(Worlds, RefuseOverBids) {
  for (std::size_t p = 0; p < policy_names.size(); ++p) {
    const auto policy = static_cast<PolicyKind>(p);
    const WorldResult audited = run_world(over_bid_world(policy, true));
    EXPECT_TRUE(audited.agreed && audited.violations.empty()) << text(audited);
    EXPECT_GE(audited.refused, 3u) << "by everybody else";
    const WorldResult unaudited = run_world(over_bid_world(policy, false));
    ASSERT_FALSE(unaudited.violations.empty()) << policy_names[p];
    EXPECT_EQ(unaudited.violations[0].checker, "refusal");
  }
}

TEST(Worlds, LoseNothingWithoutFaults) {
  WorldSettings settings = load_worlds(configs / "sim.yaml");
  const PricedResult result = run_priced(settings, 7);
  ASSERT_TRUE(result.fault_free);
  EXPECT_TRUE(result.fault_free->agreed);
  EXPECT_EQ(result.fault_free->refused, 0u);
  EXPECT_EQ(result.fault_free->calm_ns, 0);
}

}  // namespace
}  // namespace arcbid::testing
