// SPDX-License-Identifier: GPL-3.0-or-later
// What theory promises of auctions in synchronous rounds, on random instances of points.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "sim/auction/evaluate.hpp"
#include "sim/auction/rounds.hpp"
#include "tests/rounds/points.hpp"

namespace arcbid::testing {
namespace {

constexpr ScoreKind diminishing[] = {ScoreKind::independent, ScoreKind::discounted_append,
                                     ScoreKind::minimax};
constexpr ScoreKind safe[] = {ScoreKind::independent, ScoreKind::discounted_append,
                              ScoreKind::minimax, ScoreKind::minisum,
                              ScoreKind::discounted_insert_warped};
constexpr Graph graphs[] = {Graph::complete, Graph::ring, Graph::line, Graph::star};

AuctionSettings settings_of(PolicyKind policy, ScoreKind score, std::uint32_t limit) {
  AuctionSettings settings;
  settings.policy = policy;
  settings.score = score;
  settings.bundle_limit = limit;
  return settings;
}

struct Case {
  Instance instance;
  std::uint32_t limit;
};

Case random_case(std::uint64_t seed, bool ties = false) {
  const auto agents = static_cast<std::uint32_t>(2 + seed % 6);
  const auto tasks = static_cast<std::uint32_t>(1 + seed * 7 % 19);
  return {random_points(seed, agents, tasks, ties), 1 + static_cast<std::uint32_t>(seed % 5)};
}

std::size_t owners(const RoundsOutcome& outcome) {
  std::size_t owned = 0;
  for (const auto& path : outcome.paths) owned += path.size();
  return owned;
}

class Rebuild : public ::testing::TestWithParam<PolicyKind> {};

TEST_P(Rebuild, IsSequentialGreedyOnEveryGraph) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed)
    for (const ScoreKind score : safe) {
      const Case c = random_case(seed);
      const AuctionSettings settings = settings_of(GetParam(), score, c.limit);
      const auto greedy = sequential_greedy(c.instance, settings);
      for (const Graph graph : graphs) {
        SCOPED_TRACE(fmt::format("seed {}, {}, graph {}", seed, name_of(score), int(graph)));
        const RoundsOutcome outcome = run_rounds(c.instance, settings, graph);
        ASSERT_TRUE(outcome.converged && outcome.agreed);
        ASSERT_EQ(outcome.paths, greedy);
      }
    }
}

TEST_P(Rebuild, IsSequentialGreedyAmongTies) {
  for (std::uint64_t seed = 1; seed <= 250; ++seed)
    for (const ScoreKind score : {ScoreKind::independent, ScoreKind::discounted_append}) {
      const Case c = random_case(seed, true);
      const AuctionSettings settings = settings_of(GetParam(), score, c.limit);
      const RoundsOutcome outcome = run_rounds(c.instance, settings, graphs[seed % 4]);
      ASSERT_TRUE(outcome.converged && outcome.agreed);
      ASSERT_EQ(outcome.paths, sequential_greedy(c.instance, settings))
          << "seed " << seed << ", " << name_of(score);
    }
}

INSTANTIATE_TEST_SUITE_P(Of, Rebuild,
                         ::testing::Values(PolicyKind::claims, PolicyKind::cbba_rebuild),
                         [](const auto& p) {
                           return p.param == PolicyKind::claims ? "Claims" : "Cbba";
                         });

TEST(Rounds, EveryPolicyEndsWithoutConflictsAndWithAllTasksOwned) {
  for (const PolicyKind policy : {PolicyKind::claims, PolicyKind::claims_keep, PolicyKind::cbba,
                                  PolicyKind::cbba_rebuild, PolicyKind::acbba})
    for (std::uint64_t seed = 1; seed <= 60; ++seed)
      for (const ScoreKind score : safe) {
        const Case c = random_case(seed);
        const RoundsOutcome outcome =
            run_rounds(c.instance, settings_of(policy, score, c.limit), graphs[seed % 4]);
        SCOPED_TRACE(fmt::format("{}, {}, seed {}", name_of(policy), name_of(score), seed));
        if (policy == PolicyKind::acbba && !outcome.converged) continue;  // THEORY.md says why
        ASSERT_TRUE(outcome.converged && outcome.agreed);
        const std::size_t room = c.limit * c.instance.fleet.size();
        const Evaluation value = evaluate(c.instance, outcome.paths, 0.02);
        EXPECT_EQ(value.conflicts, 0u);
        EXPECT_EQ(value.assigned, std::min(room, c.instance.tasks.tasks.size()));
        EXPECT_EQ(owners(outcome), value.assigned);
      }
}

TEST(Cbba, RestsWithinTheBoundUnderDiminishingGains) {
  for (std::uint64_t seed = 1; seed <= 150; ++seed)
    for (const ScoreKind score : diminishing)
      for (const Graph graph : graphs) {
        const Case c = random_case(seed);
        const RoundsOutcome outcome =
            run_rounds(c.instance, settings_of(PolicyKind::cbba, score, c.limit), graph);
        const std::size_t room = c.limit * c.instance.fleet.size();
        const std::size_t bound = std::min(room, c.instance.tasks.tasks.size()) *
                                  diameter(graph, c.instance.fleet.size());
        EXPECT_LE(outcome.last_change_round, bound) << "seed " << seed << ", " << name_of(score);
      }
}

/// Two agents, six tasks, a score with diminishing gains, no loss: published CBBA is not sequential
/// greedy. An agent takes another task while a bid that is withdrawn later hides a better one.
TEST(Cbba, AsPublishedIsNotSequentialGreedy) {
  Instance instance;
  instance.tasks.return_home = false;
  instance.fleet = {{{1}, Vec3(310, 400, 0), 10}, {{2}, Vec3(300, 40, 0), 10}};
  const Vec3 places_m[] = {{440, 490, 0}, {60, 40, 0},   {390, 240, 0},
                           {550, 400, 0}, {340, 260, 0}, {670, 280, 0}};
  for (std::uint32_t j = 0; j < 6; ++j)
    instance.tasks.tasks.push_back(
        {.id = {j}, .arc = {j}, .first_m = places_m[j], .last_m = places_m[j], .value = 1});
  const auto run = [&](PolicyKind policy) {
    return run_rounds(instance, settings_of(policy, ScoreKind::discounted_append, 4),
                      Graph::complete);
  };
  const auto greedy =
      sequential_greedy(instance, settings_of(PolicyKind::cbba, ScoreKind::discounted_append, 4));
  for (const PolicyKind keeps : {PolicyKind::cbba, PolicyKind::claims_keep}) {
    const RoundsOutcome outcome = run(keeps);
    EXPECT_NE(outcome.paths, greedy);
    EXPECT_NEAR(evaluate(instance, outcome.paths, 0.02).score, 2.968920, 5e-7);
  }
  for (const PolicyKind rebuilds : {PolicyKind::cbba_rebuild, PolicyKind::claims})
    EXPECT_EQ(run(rebuilds).paths, greedy);
  EXPECT_NEAR(evaluate(instance, greedy, 0.02).score, 2.962503, 5e-7);
}

TEST(Cbba, ReachesHalfOfTheOptimum) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Instance instance = random_points(seed, 2 + seed % 2, 4 + seed % 2);
    const auto settings = settings_of(PolicyKind::cbba, ScoreKind::discounted_append, 3);
    const RoundsOutcome outcome = run_rounds(instance, settings, Graph::complete);
    const double score = evaluate(instance, outcome.paths, settings.discount_per_s).score;
    const double best = best_score(instance, 3, settings.discount_per_s);
    EXPECT_GE(score, 0.5 * best) << "seed " << seed;
    EXPECT_LE(score, best * (1 + 1e-12)) << "seed " << seed;
  }
}

/// Warping costs nothing where gains diminish, and cures what cycles where they do not.
TEST(Warping, MakesInsertionConvergeOnAGridOfTies) {
  std::size_t cycles = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const Instance instance = random_points(seed, 3 + seed % 3, 12, true);
    const auto run = [&](ScoreKind score) {
      return run_rounds(instance, settings_of(PolicyKind::cbba, score, 6), Graph::complete);
    };
    const RoundsOutcome warped = run(ScoreKind::discounted_insert_warped);
    ASSERT_TRUE(warped.converged && warped.agreed) << "seed " << seed;
    cycles += !run(ScoreKind::discounted_insert).converged;
  }
  EXPECT_GT(cycles, 0u) << "unwarped bids are not DMG and are known to cycle";
}

TEST(Rounds, DoNotDependOnTheOrderOfAgentsOrTasks) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Case c = random_case(seed);
    const AuctionSettings settings =
        settings_of(PolicyKind::claims, ScoreKind::discounted_append, c.limit);
    Instance turned = c.instance;
    std::reverse(turned.tasks.tasks.begin(), turned.tasks.tasks.end());
    const auto last = static_cast<std::uint32_t>(turned.tasks.tasks.size() - 1);
    for (std::uint32_t j = 0; j <= last; ++j) turned.tasks.tasks[j].id = {j};
    auto there = run_rounds(turned, settings, Graph::ring).paths;
    for (auto& path : there)
      for (TaskId& task : path) task.value = last - task.value;
    EXPECT_EQ(there, run_rounds(c.instance, settings, Graph::ring).paths) << "seed " << seed;
  }
}

TEST(Rounds, RepeatBitForBit) {
  const Case c = random_case(17);
  for (const PolicyKind policy : {PolicyKind::claims, PolicyKind::cbba, PolicyKind::acbba}) {
    const auto settings = settings_of(policy, ScoreKind::minimax, c.limit);
    const RoundsOutcome once = run_rounds(c.instance, settings, Graph::line);
    const RoundsOutcome again = run_rounds(c.instance, settings, Graph::line);
    EXPECT_EQ(once.paths, again.paths);
    EXPECT_EQ(once.bytes, again.bytes);
    EXPECT_EQ(once.messages, again.messages);
  }
}

TEST(Claims, AreProvenOneDiameterAfterAllHoldTheSame) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const Case c = random_case(seed);
    const auto settings = settings_of(PolicyKind::claims, ScoreKind::minimax, c.limit);
    for (const Graph graph : graphs) {
      const RoundsOutcome outcome = run_rounds(c.instance, settings, graph);
      const std::size_t D = diameter(graph, c.instance.fleet.size());
      ASSERT_GT(outcome.proof_round, outcome.last_change_round);
      EXPECT_LE(outcome.proof_round, std::max<std::size_t>(1, outcome.last_change_round) + 2 * D);
    }
  }
}

}  // namespace
}  // namespace arcbid::testing
