// SPDX-License-Identifier: GPL-3.0-or-later
// Whole worlds: what is shipped as configs/sim.yaml, and what the other policies do not survive.
#include <gtest/gtest.h>

#include <algorithm>
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
  run_batch(worlds_of(settings), 1, 2000, 2, [&](const PricedResult& result) {
    EXPECT_TRUE(result.world.agreed && result.world.violations.empty()) << text(result.world);
    EXPECT_LT(20 * result.world.steps, result.world.most_steps) << "seed " << result.world.seed;
    return ++worlds < 2000;
  });
  EXPECT_EQ(worlds, 2000u);
}

/// And most of them leave something, each stretch of it with a reason that the checkers accept.
TEST(Worlds, LimitedFleetsNeverFlyWhatTheyCannotAndLeaveNothingWithoutAReason) {
  WorldSettings settings = load_worlds(configs / "sim_limits.yaml");
  settings.price = false;
  std::uint64_t worlds = 0, with_some_left = 0, whole = 0;
  run_batch(worlds_of(settings), 1, 2000, 2, [&](const PricedResult& result) {
    EXPECT_TRUE(result.world.agreed && result.world.violations.empty()) << text(result.world);
    const auto is_free = [](const Belief& belief) { return !belief.winner; };
    (std::ranges::any_of(result.world.winners, is_free) ? with_some_left : whole) += 1;
    return ++worlds < 2000;
  });
  EXPECT_EQ(worlds, 2000u);
  EXPECT_GT(with_some_left, 400u);
  EXPECT_GT(whole, 200u);
}

TEST(Worlds, RepeatBitForBitWhateverTheNumberOfThreads) {
  const WorldSettings settings = load_worlds(configs / "sim.yaml");
  const auto digests = [&](unsigned jobs) {
    std::vector<std::uint64_t> out;
    run_batch(worlds_of(settings), 500, 560, jobs, [&](const PricedResult& result) {
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
  EXPECT_NE(run_priced(worlds_of(settings), 1).world.digest,
            run_priced(worlds_of(settings), 2).world.digest);
}

/// On a ring whose links had clogged, agents changed their tables at every tick, were never relayed
/// for it, and so never came to rest.
TEST(Worlds, RestUnderRebuildingCbbaThoughEverybodyTalksAllTheTime) {
  WorldSettings settings;
  settings.agents = {4, 5};
  settings.tasks = {12, 40};
  settings.policies = {PolicyKind::cbba_rebuild};
  settings.scores = {ScoreKind::discounted_append};
  settings.topologies = {TopologyKind::ring};
  settings.layouts = {Layout::clustered, Layout::scattered};
  settings.odds[static_cast<std::size_t>(WorldFault::clog)] = 1;
  for (const std::uint64_t seed : {195, 330, 431, 621, 703, 1009, 1035, 1085, 1097, 1151}) {
    const WorldResult result = run_world(make_world(settings, seed));
    EXPECT_TRUE(result.agreed) << text(result);
  }
}

TEST(Worlds, DoNotPassWhereBidsAreNotWarped) {
  WorldSettings settings = load_worlds(configs / "sim.yaml");
  settings.scores = {ScoreKind::discounted_insert};
  settings.layouts = {Layout::grid};
  settings.odds = {};
  settings.price = false;
  std::uint64_t cycling = 0;
  run_batch(worlds_of(settings), 1, 600, 2, [&](const PricedResult& result) {
    cycling += !result.world.agreed;
    return cycling == 0;
  });
  EXPECT_GT(cycling, 0u) << "insertion without warping is known to cycle";
}

/// A lease of a nanosecond: everybody says that it lives at every moment there is.
TEST(Worlds, EndThoughAgentsTalkEndlesslyAndAreSaidNotToRest) {
  WorldSettings settings = load_worlds(configs / "sim.yaml");
  settings.agents = settings.tasks = {2, 2};
  WorldSpec spec = without_faults(make_world(settings, 1));
  ASSERT_TRUE(run_world(spec).agreed);
  spec.mission.auction.lease_ns = 1;
  const WorldResult result = run_world(spec);
  EXPECT_FALSE(result.agreed);
  ASSERT_EQ(result.violations.size(), 1u);
  EXPECT_EQ(result.violations[0].checker, "liveness");
  EXPECT_EQ(result.violations[0].what, fmt::format("no end after {} steps, the most that this "
                                                   "world may take",
                                                   result.most_steps));
  EXPECT_LT(result.agreed_ns, 1'000'000) << "virtual time alone would not have ended it";
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
  const PricedResult result = run_priced(worlds_of(settings), 7);
  ASSERT_TRUE(result.fault_free);
  EXPECT_TRUE(result.fault_free->agreed);
  EXPECT_EQ(result.fault_free->refused, 0u);
  EXPECT_EQ(result.fault_free->calm_ns, 0);
}

}  // namespace
}  // namespace arcbid::testing
