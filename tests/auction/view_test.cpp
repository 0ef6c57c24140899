// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/auction/view.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "tests/auction/shuffled.hpp"

namespace arcbid::testing {
namespace {

const std::vector<AgentId> roster{{2}, {3}, {5}, {9}};

Statement claims(AgentId agent, StatementKey key, std::vector<Claim> bundle) {
  return {agent, key, Claims{std::move(bundle)}};
}

Statement table(AgentId agent, StatementKey key, std::vector<Belief> beliefs,
                std::uint64_t newest = 0) {
  return {agent, key, Table{std::move(beliefs), {0, 0, 0, newest}}};
}

Statement tombstone(AgentId agent, std::uint64_t incarnation, std::uint32_t version) {
  return claims(agent, {incarnation, true, version}, {});
}

/// What every agent said in two lives, with a death between them. One key, one content.
std::vector<Statement> history() {
  std::vector<Statement> all;
  for (const AgentId agent : roster)
    for (const std::uint64_t life : {100, 200}) {
      for (std::uint32_t version = 1; version <= 4; ++version)
        all.push_back(
            claims(agent, {life, false, version},
                   {{{version}, 1.0 * agent.value}, {{0}, -1.0 * static_cast<double>(life)}}));
      all.push_back(tombstone(agent, life, 2));
    }
  return all;
}

View merged(const std::vector<Statement>& statements) {
  View view(roster);
  for (const Statement& statement : statements) view.merge(statement);
  return view;
}

TEST(StatementKeys, AreOrderedByLifeThenDeathThenVersion) {
  EXPECT_LT((StatementKey{7, false, 1}), (StatementKey{7, false, 2}));
  EXPECT_LT((StatementKey{7, false, 900}), (StatementKey{7, true, 0})) << "death ends a life";
  EXPECT_LT((StatementKey{7, true, 900}), (StatementKey{8, false, 1})) << "a new life ends death";
  EXPECT_LT(StatementKey{}, (StatementKey{0, true, 0})) << "who was never heard can be buried";
}

TEST(View, KnowsNobodyAtFirst) {
  const View view(roster);
  for (std::size_t k = 0; k < roster.size(); ++k) {
    EXPECT_FALSE(view.heard(k));
    EXPECT_FALSE(view.dead(k));
  }
  EXPECT_EQ(view.keys(), std::vector<StatementKey>(4));
}

TEST(View, FindsMembersByIdAndNobodyElse) {
  const View view(roster);
  EXPECT_EQ(view.position({2}), 0u);
  EXPECT_EQ(view.position({9}), 3u);
  for (const std::uint32_t stranger : {0u, 1u, 4u, 10u})
    EXPECT_EQ(view.position({stranger}), std::nullopt);
}

TEST(View, KeepsTheNewestAndReportsWhetherItChanged) {
  View view(roster);
  EXPECT_TRUE(view.merge(claims({3}, {7, false, 2}, {{{1}, 5.0}})));
  EXPECT_FALSE(view.merge(claims({3}, {7, false, 2}, {{{1}, 5.0}}))) << "said twice";
  EXPECT_FALSE(view.merge(claims({3}, {7, false, 1}, {{{0}, 5.0}}))) << "older";
  EXPECT_FALSE(view.merge(claims({3}, {6, false, 9}, {{{0}, 5.0}}))) << "of an earlier life";
  EXPECT_EQ(view.key(1), (StatementKey{7, false, 2}));
  EXPECT_EQ(std::get<Claims>(view.of(1).body).bundle, (std::vector<Claim>{{{1}, 5.0}}));
  EXPECT_TRUE(view.heard(1));
}

TEST(View, BuriesAndRevives) {
  View view(roster);
  view.merge(claims({3}, {7, false, 9}, {{{1}, 5.0}}));
  EXPECT_TRUE(view.merge(tombstone({3}, 7, 1)));
  EXPECT_TRUE(view.dead(1));
  EXPECT_TRUE(view.dead(AgentId{3}));
  EXPECT_FALSE(view.merge(claims({3}, {7, false, 10}, {{{1}, 5.0}}))) << "the dead say nothing";
  EXPECT_TRUE(view.merge(claims({3}, {8, false, 1}, {})));
  EXPECT_FALSE(view.dead(1));
  EXPECT_FALSE(view.dead(AgentId{77})) << "a stranger";
}

TEST(View, IsTheSameWhateverTheOrderAndTheRepeats) {
  const auto all = history();
  const View in_order = merged(all);
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Dice dice(seed);
    std::vector<std::size_t> repeated;
    for (std::size_t n = 0; n < all.size(); ++n)
      repeated.insert(repeated.end(), 1 + dice.below(3), n);
    View view(roster);
    for (const std::size_t n : shuffled(repeated, dice)) view.merge(all[n]);
    ASSERT_EQ(view.keys(), in_order.keys());
    ASSERT_EQ(view.hash(), in_order.hash());
  }
}

TEST(View, IsTheSameHoweverKnowledgeIsGrouped) {
  // Two agents collect apart, then each learns what the other holds.
  const auto all = history();
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Dice dice(seed);
    View a(roster), b(roster);
    for (const Statement& statement : all) (dice.unit() < 0.5 ? a : b).merge(statement);
    const View old_a = a;
    for (std::size_t k = 0; k < roster.size(); ++k) a.merge(b.of(k));
    for (std::size_t k = 0; k < roster.size(); ++k) b.merge(old_a.of(k));
    EXPECT_EQ(a.hash(), b.hash());
    EXPECT_EQ(a.hash(), merged(all).hash());
  }
}

TEST(ViewHash, DependsOnEveryPartOfAStatement) {
  const std::vector<Claim> bundle{{{1}, 5.0}, {{2}, 4.0}};
  const std::vector<Statement> different{
      claims({3}, {7, false, 2}, bundle),
      claims({5}, {7, false, 2}, bundle),
      claims({3}, {8, false, 2}, bundle),
      claims({3}, {7, false, 3}, bundle),
      claims({3}, {7, false, 2}, {{{2}, 4.0}, {{1}, 5.0}}),
      claims({3}, {7, false, 2}, {{{1}, 5.0}}),
      claims({3}, {7, false, 2}, {{{1}, 5.0}, {{3}, 4.0}}),
      claims({3}, {7, false, 2}, {{{1}, 5.0}, {{2}, std::nextafter(4.0, 5.0)}}),
      claims({3}, {7, false, 2}, {}),
      tombstone({3}, 7, 2),
      table({3}, {7, false, 2}, {{AgentId{3}, 5.0}, {}}),
      table({3}, {7, false, 2}, {{AgentId{5}, 5.0}, {}}),
      table({3}, {7, false, 2}, {{}, {AgentId{3}, 5.0}}),
      table({3}, {7, false, 2}, {{AgentId{3}, 5.0}, {}}, 1),
      table({3}, {7, false, 2}, {{AgentId{3}, 5.5}, {}})};
  std::vector<std::uint64_t> hashes{View(roster).hash()};
  for (const Statement& statement : different) hashes.push_back(merged({statement}).hash());
  std::sort(hashes.begin(), hashes.end());
  EXPECT_EQ(std::adjacent_find(hashes.begin(), hashes.end()), hashes.end());
}

TEST(BestClaims, GoToTheHighestBidAndOnTiesToTheLowerId) {
  const View view = merged({claims({3}, {1, false, 1}, {{{0}, 5.0}, {{1}, 4.0}}),
                            claims({5}, {1, false, 1}, {{{0}, 6.0}, {{1}, 4.0}})});
  EXPECT_THAT(best_claims(view, 3),
              ::testing::ElementsAre(Belief{AgentId{5}, 6.0}, Belief{AgentId{3}, 4.0}, Belief{}));
}

TEST(BestClaims, LeaveOutTheDeadAndWhoeverIsToBeLeftOut) {
  View view =
      merged({claims({3}, {1, false, 1}, {{{0}, 5.0}}), claims({5}, {1, false, 1}, {{{0}, 6.0}})});
  EXPECT_EQ(best_claims(view, 1, AgentId{5})[0], (Belief{AgentId{3}, 5.0}));
  EXPECT_EQ(best_claims(view, 1, AgentId{3})[0], (Belief{AgentId{5}, 6.0}));
  view.merge(claims({5}, {1, true, 1}, {{{0}, 6.0}}));  // the last will of the dead is void too
  EXPECT_EQ(best_claims(view, 1)[0], (Belief{AgentId{3}, 5.0}));
}

}  // namespace
}  // namespace arcbid::testing
