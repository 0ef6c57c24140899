// SPDX-License-Identifier: GPL-3.0-or-later
// Published CBBA: the phases of one agent.
#include "core/auction/cbba.hpp"

#include <gmock/gmock.h>

#include "tests/auction/fleet.hpp"
#include "tests/auction/scripted_score.hpp"

namespace arcbid::testing {
namespace {

const std::vector<AgentId> roster{{1}, {2}, {3}, {4}};
constexpr AgentId self{1};
constexpr std::size_t second = 1, third = 2;  // roster positions

CbbaState scripted(ScriptedScore::Gain gain, std::size_t tasks) {
  auto score = std::make_unique<ScriptedScore>(std::move(gain));
  return CbbaState(self, roster, Bundle(self, std::move(score), tasks, 0), tasks);
}

/// Bids 100, 90, 80 … by task, and one less for every task already taken: a task that is bid for
/// anew shows it in its bid.
double falling(TaskId j, const std::vector<PathStop>& path) {
  return 100.0 - 10.0 * j.value - static_cast<double>(path.size());
}

Table nothing_known(std::size_t tasks) {
  return {std::vector<Belief>(tasks), {0, 0, 0, 0}};
}

std::vector<TaskId> flown(const CbbaState& state) {
  std::vector<TaskId> tasks;
  for (const PathStop& stop : state.bundle().path()) tasks.push_back(stop.task);
  return tasks;
}

TEST(CbbaState, BidsForAllThatIsFree) {
  CbbaState state = scripted(falling, 3);
  state.release();
  state.bid();
  EXPECT_THAT(state.table().beliefs,
              ::testing::ElementsAre(Belief{self, 100.0}, Belief{self, 89.0}, Belief{self, 78.0}));
}

class ReleaseCascade : public ::testing::TestWithParam<std::uint32_t> {};

TEST_P(ReleaseCascade, FreesTheTaskLostAndAllThatWereBundledAfterIt) {
  constexpr std::uint32_t tasks = 5;
  const std::uint32_t q = GetParam();
  CbbaState state = scripted(falling, tasks);
  state.release();
  state.bid();
  const std::vector<Claim> before = state.bundle().claims();
  ASSERT_EQ(before.size(), tasks);
  Table message = nothing_known(tasks);
  message.beliefs[q] = {AgentId{2}, 1000.0};
  state.receive(second, message, 1);
  state.release();
  state.bid();

  const std::vector<Claim>& after = state.bundle().claims();
  ASSERT_EQ(after.size(), tasks - 1);
  for (std::uint32_t n = 0; n < q; ++n) EXPECT_EQ(after[n], before[n]) << "was not after the loss";
  for (std::uint32_t n = q; n < tasks - 1; ++n) {
    EXPECT_EQ(after[n].task, before[n + 1].task);
    EXPECT_EQ(after[n].bid, before[n + 1].bid + 1) << "was not released and bid for again";
    EXPECT_EQ(state.table().beliefs[after[n].task.value], (Belief{self, after[n].bid}));
  }
  EXPECT_EQ(state.table().beliefs[q], (Belief{AgentId{2}, 1000.0}));
  // New stops go to the front: what was kept still stands at the back, in its old order.
  std::vector<TaskId> path;
  for (std::uint32_t j = tasks; j-- > 0;)
    if (j != q) path.push_back({j});
  EXPECT_EQ(flown(state), path);
}

INSTANTIATE_TEST_SUITE_P(AtPosition, ReleaseCascade, ::testing::Range(0u, 5u));

TEST(ReleaseCascade, AlsoFollowsAReset) {
  CbbaState state = scripted(falling, 3);
  state.release();
  state.bid();
  Table message = nothing_known(3);
  message.beliefs[0] = {AgentId{2}, 1000.0};
  state.receive(second, message, 1);
  state.release();
  state.bid();
  ASSERT_EQ(state.bundle().claims().size(), 2u);
  message.beliefs[0] = {};  // row 15: the winner gave it up
  state.receive(second, message, 2);
  state.release();
  state.bid();
  EXPECT_EQ(state.table().beliefs[0].winner, self);
  EXPECT_EQ(state.bundle().claims().size(), 3u);
}

TEST(CbbaTimestamps, AreTheRoundForTheSenderAndTheLatestNewsForOthers) {
  CbbaState state = scripted(falling, 1);
  state.receive(second, {{{}}, {0, 1, 5, 2}}, 7);
  EXPECT_THAT(state.table().timestamps, ::testing::ElementsAre(::testing::_, 7, 5, 2));
  state.receive(third, {{{}}, {0, 6, 8, 9}}, 9);
  EXPECT_THAT(state.table().timestamps, ::testing::ElementsAre(::testing::_, 7, 9, 9));
}

TEST(CbbaTimestamps, NeverGoBack) {
  Dice dice(5);
  CbbaState state = scripted(falling, 1);
  for (std::uint64_t round = 1; round <= 200; ++round) {
    const auto before = state.table().timestamps;
    Table message = nothing_known(1);
    for (std::uint64_t& stamp : message.timestamps) stamp = dice.below(round);
    state.receive(1 + dice.below(3), message, round);
    for (std::size_t m = 1; m < roster.size(); ++m)
      ASSERT_GE(state.table().timestamps[m], before[m]);
  }
}

TEST(CbbaState, ForgetsTheDeadAndNobodyElse) {
  CbbaState state = scripted(falling, 3);
  state.receive(second, {{{AgentId{2}, 5.0}, {AgentId{3}, 6.0}, {AgentId{2}, 7.0}}, {0, 0, 3, 0}},
                1);
  state.forget({2});
  EXPECT_THAT(state.table().beliefs,
              ::testing::ElementsAre(Belief{}, Belief{AgentId{3}, 6.0}, Belief{}));
}

View view_with(const Table& table, bool dead = false) {
  View view(roster);
  view.merge({{2}, {50, false, 1}, table});
  if (dead) view.merge({{2}, {50, true, 1}, Claims{}});
  return view;
}

TEST(CbbaPolicy, IsSettledOnceARoundChangesNothing) {
  CbbaPolicy policy(scripted(falling, 3));
  Table rival = nothing_known(3);
  rival.beliefs[1] = {AgentId{2}, 500.0};
  const View view = view_with(rival);
  const Decision first = policy.decide(view);
  EXPECT_TRUE(first.changed);
  EXPECT_FALSE(first.settled);
  const Decision again = policy.decide(view);
  EXPECT_FALSE(again.changed);
  EXPECT_TRUE(again.settled);
  EXPECT_EQ(policy.winners(view)[1].winner, AgentId{2});
  EXPECT_EQ(std::get<Table>(policy.statement()).beliefs, policy.winners(view));
}

TEST(CbbaPolicy, TakesOverFromTheDead) {
  CbbaPolicy policy(scripted(falling, 3));
  Table rival = nothing_known(3);
  rival.beliefs[1] = {AgentId{2}, 500.0};
  policy.decide(view_with(rival));
  View view = view_with(rival, true);
  EXPECT_TRUE(policy.decide(view).changed);
  EXPECT_EQ(policy.winners(view)[1].winner, self);
}

TEST(CbbaPolicy, DoesNotLearnOfADeadWinnerFromTheLiving) {
  CbbaPolicy policy(scripted(falling, 1));
  View view = view_with(nothing_known(1), true);
  view.merge({{3}, {60, false, 1}, Table{{{AgentId{2}, 500.0}}, {0, 99, 0, 0}}});
  policy.decide(view);
  EXPECT_EQ(policy.winners(view)[0].winner, self);
}

TEST(CbbaPolicy, SeesWhetherTheLivingBelieveTheSame) {
  CbbaPolicy policy(scripted(falling, 1));
  View view = view_with({{{AgentId{2}, 500.0}}, {0, 0, 0, 0}});
  policy.decide(view);
  EXPECT_TRUE(policy.agrees(view));
  view.merge({{3}, {60, false, 1}, nothing_known(1)});
  EXPECT_FALSE(policy.agrees(view)) << "agent 3 knows of no winner";
  view.merge({{3}, {60, true, 1}, Claims{}});
  EXPECT_TRUE(policy.agrees(view)) << "the dead need not agree";
}

}  // namespace
}  // namespace arcbid::testing
