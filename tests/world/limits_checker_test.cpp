// SPDX-License-Identifier: GPL-3.0-or-later
// Histories in which somebody flies what it cannot, or something is left for no good reason.
#include "sim/world/checkers/limits.hpp"
#include "tests/world/checker_fixture.hpp"

namespace arcbid::testing {
namespace {

/// Agent 1 has task 0, agent 2 task 2; nobody has task 1, from x = 50 to 55, for a reason.
class LimitsCheckerTest : public CheckerTest {
 protected:
  void prove(NoBidderReason why) {
    decides(1, 1, {a});
    decides(2, 1, {c});
    Agreement proof = agreement(1, {{0}});
    NoBidder left;
    left.arc = {1};
    left.to_m = 5;
    left.why = why;
    proof.left = {left};
    proves(1, proof);
  }
};

TEST_F(LimitsCheckerTest, TakesAReasonThatHolds) {
  mission.fleet[0].endurance_s = 109.9;  // alone it takes 110 s, the other one 100
  mission.fleet[1].endurance_s = 99.9;
  prove(NoBidderReason::endurance);
  EXPECT_TRUE(finds_nothing());
}

TEST_F(LimitsCheckerTest, SeesAReasonThatDoesNotHold) {
  mission.fleet[0].endurance_s = 109.9;
  mission.fleet[1].endurance_s = 100.1;
  prove(NoBidderReason::endurance);
  EXPECT_TRUE(finds("limits"));
}

TEST_F(LimitsCheckerTest, SeesThatSomebodyCarriesThePayload) {
  mission.arcs[1].payload = Payload::camera;
  mission.fleet[0].payload = Payload::lidar;
  prove(NoBidderReason::payload);
  EXPECT_TRUE(finds("limits"));
}

TEST_F(LimitsCheckerTest, TakesAPayloadThatNobodyCarries) {
  mission.arcs[1].payload = Payload::camera;
  for (Uav& uav : mission.fleet) uav.payload = Payload::lidar;
  prove(NoBidderReason::payload);
  EXPECT_TRUE(finds_nothing());
}

TEST_F(LimitsCheckerTest, SeesWhoCouldFlyWhatIsLeft) {
  prove(NoBidderReason::endurance_left);
  EXPECT_TRUE(finds("limits"));
}

TEST_F(LimitsCheckerTest, SeesATourThatLastsTooLong) {
  mission.fleet[0].endurance_s = 49.9;  // there and back is 50
  mission.fleet[1].endurance_s = 99.9;
  prove(NoBidderReason::endurance);
  EXPECT_TRUE(finds("limits"));
}

TEST_F(LimitsCheckerTest, SeesAnArcFlownWithoutItsPayload) {
  mission.arcs[0].payload = Payload::camera;
  mission.fleet[0].payload = Payload::lidar;
  decides(1, 1, {a, b});
  decides(2, 1, {c});
  proves(1, agreement(1, {{0}, {1}}));
  EXPECT_TRUE(finds("limits"));
}

TEST_F(LimitsCheckerTest, SeesAReasonGivenForWhatIsWon) {
  decides(1, 1, {a, b});
  decides(2, 1, {c});
  Agreement proof = agreement(1, {{0}, {1}});
  NoBidder left;
  left.arc = {1};
  left.to_m = 5;
  proof.left = {left};
  proves(1, proof);
  EXPECT_TRUE(finds("limits"));
}

TEST_F(OutcomeTest, OfSequentialGreedyOffersNothingThatCannotBeFlown) {
  mission.fleet[0].endurance_s = 60;
  mission.fleet[1].endurance_s = 99;  // the middle piece would take 100
  const Uav &left = mission.fleet[0], &right = mission.fleet[1];
  const std::vector<Bidder> good{{left, {{{0}, -50}}, {{{0}, false}}},
                                 {right, {{{2}, -40}}, {{{2}, true}}}};
  EXPECT_TRUE(greedy(good).empty()) << greedy(good).front();
  const std::vector<Bidder> too_much{
      {good[0]}, {right, {{{2}, -40}, {{1}, -100}}, {{{2}, true}, {{1}, true}}}};
  EXPECT_FALSE(greedy(too_much).empty());
  const std::vector<Bidder> too_little{{left, {}, {}}, good[1]};
  EXPECT_FALSE(greedy(too_little).empty()) << "the first one could fly its piece";
  mission.arcs[0].payload = Payload::camera;
  const Uav blind{{1}, Vec3(0, 0, 0), 1, 60, Payload::lidar};
  EXPECT_FALSE(greedy({{blind, {{{0}, -50}}, {{{0}, false}}}, good[1]}).empty());
  EXPECT_TRUE(greedy({{blind, {}, {}}, good[1]}).empty());
}

}  // namespace
}  // namespace arcbid::testing
