// SPDX-License-Identifier: GPL-3.0-or-later
// The auction as a whole, in virtual time: agreement is reached, proven and never contradicted, and
// what is agreed is the sequential greedy allocation of the living.
#include <gmock/gmock.h>

#include <set>

#include "tests/auction/fleet.hpp"

namespace arcbid::testing {
namespace {

constexpr TimeNs second = 1'000'000'000;

void expect_sound(const Fleet& fleet) {
  const auto living = fleet.living();
  const Agreement& first = *fleet.agreement(living.front());
  EXPECT_EQ(first.members, living);
  std::map<TaskId, AgentId> owner;
  for (const AgentId id : living) {
    const Agreement& agreement = *fleet.agreement(id);
    EXPECT_EQ(agreement.winners, first.winners) << "agent " << id.value;
    for (const PathStop& stop : agreement.path) {
      EXPECT_TRUE(owner.emplace(stop.task, id).second) << "task with two owners";
      EXPECT_EQ(first.winners[stop.task.value].winner, id);
    }
  }
  EXPECT_EQ(owner.size(), fleet.agent(living.front()).tasks().tasks.size()) << "tasks left over";
}

void expect_sequential_greedy(const Fleet& fleet) {
  const auto living = fleet.living();
  const Agent& agent = fleet.agent(living.front());
  const auto expected = sequential_greedy(fleet.mission(), agent.tasks(), living);
  const auto& got = fleet.agreement(living.front())->winners;
  for (std::size_t j = 0; j < expected.size(); ++j) {
    EXPECT_EQ(got[j].winner, expected[j].winner) << "task " << j;
    EXPECT_NEAR(got[j].bid, expected[j].bid, 1e-6) << "task " << j;
  }
}

struct World {
  std::uint32_t agents, arcs;
  double loss, duplicate;
  TimeNs most_ns;
};

class ClaimsAgreement : public ::testing::TestWithParam<World> {};

TEST_P(ClaimsAgreement, IsSequentialGreedyWhateverTheNetworkDoes) {
  const World world = GetParam();
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Fleet fleet(random_mission(seed, world.agents, world.arcs),
                {.loss = world.loss, .duplicate = world.duplicate, .most_ns = world.most_ns}, seed);
    fleet.run_for(second / 2);  // the start is an event of its own
    ASSERT_TRUE(fleet.run(60 * second));
    expect_sound(fleet);
    expect_sequential_greedy(fleet);
    fleet.run_for(5 * second);
    EXPECT_EQ(fleet.agreement(fleet.living().front()).has_value(), true)
        << "the proof did not last";
  }
}

INSTANTIATE_TEST_SUITE_P(
    Worlds, ClaimsAgreement,
    ::testing::Values(World{1, 5, 0, 0, 2'000'000}, World{2, 6, 0, 0, 2'000'000},
                      World{4, 10, 0, 0, 5'000'000}, World{4, 10, 0.3, 0.2, 50'000'000},
                      World{6, 8, 0.6, 0.3, 100'000'000}, World{3, 1, 0.2, 0, 5'000'000},
                      World{5, 2, 0.5, 0.5, 200'000'000}));

TEST(Agreement, SurvivesTheDeathOfAnAgentAtAnyTime) {
  for (TimeNs at = 0; at < 600'000'000; at += 23'000'000) {
    SCOPED_TRACE("killed at " + std::to_string(at));
    Fleet fleet(random_mission(7, 4, 10), {.loss = 0.2}, 11);
    fleet.run_for(at);
    fleet.kill({2});
    fleet.run_for(3 * second);  // until then the dead member may sit in a proof: nobody can know
    ASSERT_TRUE(fleet.run(60 * second));
    expect_sound(fleet);
    expect_sequential_greedy(fleet);
  }
}

TEST(Agreement, TakesBackAnAgentThatReturns) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Fleet fleet(random_mission(seed, 4, 8), {.loss = 0.3, .duplicate = 0.2}, seed);
    ASSERT_TRUE(fleet.run(60 * second));
    fleet.kill({3});
    fleet.run_for(seed * second / 2);  // some return before anybody noticed
    fleet.revive({3});
    fleet.run_for(second);
    ASSERT_TRUE(fleet.run(60 * second)) << "seed " << seed;
    expect_sound(fleet);
    expect_sequential_greedy(fleet);
  }
}

TEST(Agreement, SidesThatNeverHeardEachOtherMeetWhenThePartitionHeals) {
  Mission mission = random_mission(4, 4, 8);
  mission.auction.barrier_ns = 500'000'000;
  Fleet fleet(mission, {}, 4);
  fleet.partition({{{1}, 0}, {{2}, 0}, {{3}, 1}, {{4}, 1}});
  fleet.run_for(5'000'000'000);  // each side has buried members of whom it never heard
  fleet.partition({});
  ASSERT_TRUE(fleet.run(10'000'000'000));
  EXPECT_EQ(fleet.agreement({1})->members.size(), 4u);
}

TEST(Agreement, BothSidesOfAPartitionFinishAndOneAllocationIsLeftWhenItHeals) {
  Fleet fleet(random_mission(5, 5, 9), {.loss = 0.1}, 3);
  fleet.run_for(100'000'000);
  fleet.partition({{{1}, 0}, {{2}, 0}, {{3}, 1}, {{4}, 1}, {{5}, 1}});
  fleet.run_for(20 * second);
  for (const AgentId id : fleet.living()) ASSERT_TRUE(fleet.agreement(id)) << id.value;
  EXPECT_THAT(fleet.agreement({1})->members, ::testing::ElementsAre(AgentId{1}, AgentId{2}));
  EXPECT_EQ(fleet.agreement({3})->members.size(), 3u);
  for (const Belief& belief : fleet.agreement({1})->winners) ASSERT_TRUE(belief.winner);
  fleet.partition({});
  fleet.run_for(second);
  ASSERT_TRUE(fleet.run(60 * second));
  expect_sound(fleet);
  expect_sequential_greedy(fleet);
}

TEST(Agreement, IsNeverProvenTooEarly) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Fleet fleet(random_mission(seed, 5, 6), {.loss = 0.5, .duplicate = 0.3, .most_ns = 80'000'000},
                seed);
    ASSERT_TRUE(fleet.run(60 * second));
    const auto before = fleet.agreement({1})->winners;
    fleet.run_for(second);
    ASSERT_TRUE(fleet.agreement({1}));
    EXPECT_EQ(fleet.agreement({1})->winners, before) << "seed " << seed;
  }
}

TEST(Agreement, HoldsForEveryScoreAndPolicy) {
  for (const PolicyKind policy : {PolicyKind::claims, PolicyKind::cbba})
    for (const ScoreKind score :
         {ScoreKind::minimax, ScoreKind::minisum, ScoreKind::discounted_insert_warped,
          ScoreKind::minimax_long_first})
      for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        SCOPED_TRACE(std::to_string(int(policy)) + "/" + std::to_string(int(score)) + "/" +
                     std::to_string(seed));
        Mission mission = random_mission(seed, 4, 12);
        mission.auction.policy = policy;
        mission.auction.score = score;
        Fleet fleet(mission, {.loss = 0.2, .duplicate = 0.1, .most_ns = 30'000'000}, seed);
        ASSERT_TRUE(fleet.run(60 * second));
        expect_sound(fleet);
      }
}

TEST(Agreement, UnderPublishedCbbaSurvivesADeath) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Mission mission = random_mission(seed, 4, 10);
    mission.auction.policy = PolicyKind::cbba;
    Fleet fleet(mission, {.loss = 0.2}, seed);
    fleet.run_for(150'000'000);
    fleet.kill({1});
    fleet.run_for(3 * second);
    ASSERT_TRUE(fleet.run(60 * second)) << "seed " << seed;
    expect_sound(fleet);
  }
}

TEST(Agreement, RespectsTheBundleLimit) {
  Mission mission = random_mission(3, 3, 6);
  const auto tasks = split(mission.arcs, mission.auction.split_m, 1000).tasks.size();
  mission.auction.bundle_limit = static_cast<std::uint32_t>((tasks + 2) / 3);
  Fleet fleet(mission, {}, 1);
  ASSERT_TRUE(fleet.run(60 * second));
  expect_sound(fleet);
  for (const AgentId id : fleet.living())
    EXPECT_LE(fleet.agreement(id)->path.size(), mission.auction.bundle_limit);
}

TEST(Agreement, LeavesWhatNobodyMayTakeWithoutAnOwner) {
  Mission mission = random_mission(3, 2, 6);
  mission.auction.bundle_limit = 1;
  Fleet fleet(mission, {}, 1);
  ASSERT_TRUE(fleet.run(60 * second));
  const auto& winners = fleet.agreement({1})->winners;
  EXPECT_EQ(std::count_if(winners.begin(), winners.end(), [](const Belief& b) { return b.winner; }),
            2);
}

TEST(Agreement, IsTheSameBitForBitWhenRunAgain) {
  const auto once = [] {
    Fleet fleet(random_mission(9, 5, 12), {.loss = 0.4, .duplicate = 0.2}, 9);
    fleet.run(60 * second);
    return std::tuple(fleet.now_ns(), fleet.messages(), fleet.agreement({1})->view_hash);
  };
  EXPECT_EQ(once(), once());
}

}  // namespace
}  // namespace arcbid::testing
