// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/replay/playback.hpp"

#include <gtest/gtest.h>

#include "tests/replay/recorded_fleet.hpp"

namespace arcbid {
namespace {

using testing::RecordedFleet;

constexpr TimeNs s = 1'000'000'000;

class Beliefs : public ::testing::TestWithParam<PolicyKind> {};
INSTANTIATE_TEST_SUITE_P(Playback, Beliefs,
                         ::testing::Values(PolicyKind::claims, PolicyKind::claims_keep,
                                           PolicyKind::cbba, PolicyKind::acbba));

TEST_P(Beliefs, AreTheCoresAfterEveryStep) {
  const testing::TemporaryFolder folder;
  Mission mission = testing::random_mission(3, 3, 5);
  mission.auction.policy = GetParam();
  RecordedFleet fleet(mission, folder.path(), 3, 0.1);
  fleet.keep_winners();
  ASSERT_TRUE(fleet.run(60 * s));
  fleet.kill({2});
  fleet.run_for(4 * s);
  const auto winners = fleet.winners();
  fleet.end();
  const RunArchive run = open_run(folder.path());
  const Playback playback(run);
  std::size_t compared = 0;
  for (std::size_t l = 0; l < run.lives.size(); ++l) {
    const auto& of_core = winners.at(run.lives[l].agent());
    for (std::size_t step = 0; step < of_core.size(); ++step, ++compared)
      ASSERT_EQ(playback.beliefs(l, step + 1), of_core[step])
          << "agent " << run.lives[l].agent().value << ", step " << step;
  }
  EXPECT_EQ(compared, playback.moments().size());
}

TEST(Playback, KnowsWhoIsWhatAtAnyMoment) {
  const testing::TemporaryFolder folder;
  RecordedFleet fleet(testing::random_mission(3, 3, 5), folder.path(), 3);
  ASSERT_TRUE(fleet.run(60 * s));
  fleet.kill({2});
  fleet.run_for(4 * s);
  fleet.end();
  const RunArchive run = open_run(folder.path());
  const Playback playback(run);
  using State = Playback::State;
  for (const auto& state : playback.agents(0)) EXPECT_EQ(state.state, State::unborn);
  const auto last = playback.agents(playback.moments().size());
  EXPECT_EQ(last[0].state, State::ended);
  EXPECT_EQ(last[1].state, State::dead);
  for (const Belief& owner : playback.owners(playback.moments().size())) {
    ASSERT_TRUE(owner.winner);
    EXPECT_NE(*owner.winner, AgentId{2});
  }
}

}  // namespace
}  // namespace arcbid
