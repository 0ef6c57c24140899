// SPDX-License-Identifier: GPL-3.0-or-later
// The start barrier: nobody bids before everybody is present, and nobody waits for ever.
#include <gmock/gmock.h>

#include "tests/auction/agent_fixture.hpp"

namespace arcbid::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

using StartTest = AgentTest;

TEST_F(StartTest, DoesNotStartBeforeEverybodyIsPresent) {
  EXPECT_FALSE(tick().started);
  EXPECT_FALSE(hear(status(first, Phase::waiting_for_peers)).started);
  EXPECT_FALSE(hear(status(third, Phase::waiting_for_peers, 1)).started)
      << "agent 3 misses somebody";
  EXPECT_EQ(agent->phase(), Phase::waiting_for_peers);
  EXPECT_TRUE(hear(status(third, Phase::waiting_for_peers)).started);
  EXPECT_EQ(agent->phase(), Phase::auction);
}

TEST_F(StartTest, DoesNotStartBeforeItReachesEverybodyItself) {
  tick(1);
  hear(status(first, Phase::waiting_for_peers));
  EXPECT_FALSE(hear(status(third, Phase::waiting_for_peers)).started);
  EXPECT_TRUE(tick(2).started);
}

TEST_F(StartTest, StartsWhenSomebodyElseHas) {
  tick(1);
  EXPECT_TRUE(hear(status(first, Phase::auction)).started);
}

TEST_F(StartTest, StartsAtTheEndOfTheBarrierWithoutThoseNeverHeard) {
  tick_until(
      [&](const Update& update) {
        if (now < 9 * second) hear(status(first, Phase::waiting_for_peers, 1));
        return update.started;
      },
      1);
  EXPECT_EQ(now, mission->auction.barrier_ns);
  EXPECT_EQ(wake_ns, now);
  EXPECT_THAT(tick(1).died, ElementsAre(third)) << "silent all along, and nobody waits again";
}

TEST_F(StartTest, CountsSilenceFromTheStart) {
  tick();
  hear(status(first, Phase::waiting_for_peers));
  now = 5 * second;
  EXPECT_THAT(hear(status(third, Phase::waiting_for_peers)).died, IsEmpty());
  now += mission->auction.lease_ns;
  EXPECT_THAT(tick().died, IsEmpty());
}

TEST_F(StartTest, BidsAsSoonAsItHasStarted) {
  start();
  settle();
  const auto& bundle = std::get<Claims>(agent->view().of(at_self).body).bundle;
  EXPECT_EQ(bundle.size(), agent->tasks().tasks.size()) << "nobody else claims anything";
  EXPECT_EQ(agent->view().key(at_self).incarnation, own_life);
}

/// The time before the start is not wasted: the first statement is what it would take alone.
TEST_F(StartTest, StatesItsFirstDecisionAtTheStart) {
  start();
  EXPECT_EQ(agent->view().key(at_self).version, 1u);
  const auto& bundle = std::get<Claims>(agent->view().of(at_self).body).bundle;
  EXPECT_EQ(bundle.size(), agent->tasks().tasks.size());
}

TEST_F(StartTest, SaysNothingOfItsWorkWhileItWaits) {
  const Update update = tick(1);
  EXPECT_THAT(update.bids, IsEmpty());
  ASSERT_EQ(update.statuses.size(), 1u);
  EXPECT_EQ(update.statuses[0].phase, Phase::waiting_for_peers);
}

TEST_F(StartTest, DoesNotMindAPeerThatHasNoMissionYet) {
  StatusMessage message;
  message.header = {first, life(first), 1, 0, 0};
  const Update update = hear(message);
  EXPECT_EQ(update.refused, std::nullopt);
  EXPECT_FALSE(update.started);
}

}  // namespace
}  // namespace arcbid::testing
