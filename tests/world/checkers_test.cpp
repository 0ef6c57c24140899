// SPDX-License-Identifier: GPL-3.0-or-later
// Every checker is shown a history in which its property does not hold, and must say so.
#include "sim/world/checkers/checkers.hpp"

#include <gtest/gtest.h>

#include "tests/world/checker_fixture.hpp"

namespace arcbid::testing {
namespace {

TEST_F(CheckerTest, FindNothingInAGoodHistory) {
  decides(1, 1, {a, b});
  decides(2, 1, {c});
  proves(1, agreement(1, {{0}, {1}}));
  proves(2, agreement(2, {{2}}));
  EXPECT_TRUE(finds_nothing());
}

TEST_F(CheckerTest, SeeAVersionThatSaysTwoThings) {
  decides(1, 1, {a});
  Update update;
  update.decision = DecisionMade{2, true, {7, false, 1}, Claims{{c}}, {{{2}, false}}};
  decides(1, update);
  EXPECT_TRUE(finds("statements"));
}

TEST_F(CheckerTest, SeeABidThatNobodyMade) {
  view.merge({{2}, {7, false, 1}, Claims{{{{2}, -1}}}});
  decides(1, 1, {a});
  EXPECT_TRUE(finds("winning-bids"));
}

TEST_F(CheckerTest, SeeAPathOfOtherTasksThanTheBundle) {
  Update update;
  update.decision = DecisionMade{1, true, {7, false, 1}, Claims{{a}}, {{{1}, false}}};
  view.merge({{1}, {7, false, 1}, Claims{{a}}});
  decides(1, update);
  EXPECT_FALSE(finds_nothing());
}

TEST_F(CheckerTest, SeeABidAboveAnEarlierOneOfItsBundle) {
  decides(1, 1, {b, a});
  EXPECT_FALSE(finds_nothing());
}

TEST_F(CheckerTest, SeeATaskWithTwoOwners) {
  decides(1, 1, {a, b});
  decides(2, 1, {c, {{1}, -120}});
  proves(1, agreement(1, {{0}, {1}}));
  EXPECT_TRUE(finds("proof"));
}

TEST_F(CheckerTest, SeeATaskWithoutAnOwner) {
  decides(1, 1, {a});
  decides(2, 1, {c});
  proves(1, agreement(1, {{0}}));
  EXPECT_TRUE(finds("limits"));
}

TEST_F(CheckerTest, SeeAnOwnerWhoDoesNotFlyItsTask) {
  decides(1, 1, {a, b});
  decides(2, 1, {c});
  proves(1, agreement(1, {{0}}));
  EXPECT_TRUE(finds("proof"));
}

TEST_F(CheckerTest, SeeTwoOutcomesUnderOneHash) {
  decides(1, 1, {a, b});
  decides(2, 1, {c});
  proves(1, agreement(1, {{0}, {1}}));
  decides(1, 2, {a});
  decides(2, 2, {c, {{1}, -110}});
  proves(2, agreement(2, {{2}, {1}}));
  EXPECT_TRUE(finds("proof"));
}

TEST_F(CheckerTest, SeeAChangeOfMindAfterAProof) {
  decides(1, 1, {a, b});
  decides(2, 1, {c});
  proves(1, agreement(1, {{0}, {1}}));
  decides(2, 2, {c, {{1}, -115}});
  EXPECT_TRUE(finds("stability"));
}

TEST_F(CheckerTest, LetANewLifeChangeItsMind) {
  decides(1, 1, {a, b});
  decides(2, 1, {c});
  proves(1, agreement(1, {{0}, {1}}));
  Update update;
  update.decision = DecisionMade{1, true, {9, false, 1}, Claims{{c}}, {{{2}, false}}};
  view.merge({{2}, {9, false, 1}, Claims{{c}}});
  checkers.after({now_ns++, {2}, 22, update, view, nullptr});
  EXPECT_FALSE(finds("stability"));
}

TEST_F(OutcomeTest, OfSequentialGreedyPassesAndAnyOtherDoesNot) {
  const Uav &left = mission.fleet[0], &right = mission.fleet[1];
  // Closed tours: to 25 and back is 50; to 85 - 80 and back from 100 is 40; the middle piece makes
  // the right one's tour 100 long and the left one's 110.
  const std::vector<Bidder> good{{left, {{{0}, -50}}, {{{0}, false}}},
                                 {right, {{{2}, -40}, {{1}, -100}}, {{{2}, true}, {{1}, true}}}};
  EXPECT_TRUE(greedy(good).empty()) << greedy(good).front();
  const std::vector<Bidder> other{{left, {{{0}, -50}, {{1}, -110}}, {{{0}, false}, {{1}, false}}},
                                  {right, {{{2}, -40}}, {{{2}, true}}}};
  EXPECT_FALSE(greedy(other).empty());
  const std::vector<Bidder> wrong_bid{{left, {{{0}, -49}}, {{{0}, false}}}, good[1]};
  EXPECT_FALSE(greedy(wrong_bid).empty());
}

TEST_F(OutcomeTest, MustCoverEveryArcOnceToTheMillimetre) {
  const auto findings_of = [&](const std::vector<Piece>& pieces) {
    Findings findings;
    check_cover(mission, pieces, 0, findings);
    return findings.found().size();
  };
  EXPECT_EQ(findings_of({{{2}, 0, 5}, {{0}, 0, 5}, {{1}, 0, 2}, {{1}, 2, 5}}), 0u);
  EXPECT_GT(findings_of({{{0}, 0, 5}, {{1}, 0, 5}}), 0u);                   // one is missing
  EXPECT_GT(findings_of({{{0}, 0, 5}, {{1}, 0, 5}, {{2}, 0, 4.998}}), 0u);  // a gap
  EXPECT_GT(findings_of({{{0}, 0, 5}, {{0}, 0, 5}, {{1}, 0, 5}, {{2}, 0, 5}}), 0u);  // twice
}

TEST_F(OutcomeTest, MustBeSplitAsTheCheckersCut) {
  const auto findings_of = [&](const std::vector<Task>& tasks) {
    Findings findings;
    check_split(cut(mission), tasks, findings);
    return findings.found().size();
  };
  TaskSet set = split(mission.arcs, mission.auction.split_m, 1000);
  EXPECT_EQ(findings_of(set.tasks), 0u);
  set.tasks[1].to_m -= 0.01;
  EXPECT_GT(findings_of(set.tasks), 0u);
  set.tasks.pop_back();
  EXPECT_GT(findings_of(set.tasks), 0u);
}

TEST(Cut, IsThatOfTheAuctionOnBentArcsWithoutAPieceLengthAndAboveTheLimitOfTasks) {
  Mission mission = small_mission();
  std::vector<Waypoint>& bent = mission.arcs[1].waypoints;
  bent = {bent[0], {Vec3(50, 7, 0), Vec3::UnitZ()}, {Vec3(62, 7, 3), Vec3::UnitZ()}, bent[1]};
  mission.arcs[2].waypoints.back().position_m.x() += 33;
  for (const std::optional<double> split_m : {std::optional<double>(), std::optional(0.7)})
    for (const std::uint32_t most : {1000u, 20u, 1u}) {
      mission.auction.split_m = split_m;
      mission.auction.max_tasks = most;
      Findings findings;
      check_split(cut(mission), split(mission.arcs, split_m, most).tasks, findings);
      EXPECT_TRUE(findings.found().empty()) << findings.found().front().what;
    }
}

}  // namespace
}  // namespace arcbid::testing
