// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever nobody flies has a reason, and the reason is true.
#include "core/auction/no_bidders.hpp"

#include <gmock/gmock.h>

#include "tests/auction/fleet.hpp"

namespace arcbid::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// UAVs at the origin at 1 m/s. Arcs along x, in two pieces of 10 m each, that begin at 0, 100, 200
/// and so on: home to home 20 s for the first piece of arc 0, and 200 s more for every arc further.
struct Line {
  explicit Line(std::uint32_t arcs, std::vector<double> endurances_s) {
    for (std::uint32_t m = 0; m < arcs; ++m)
      mission.arcs.push_back(
          {{m},
           ArcKind::outline,
           {{Vec3(100 * m, 0, 0), Vec3::UnitX()}, {Vec3(100 * m + 20, 0, 0), Vec3::UnitX()}}});
    for (const double endurance_s : endurances_s) {
      const auto id = static_cast<std::uint32_t>(members.size() + 1);
      members.push_back({{{id}, Vec3::Zero(), 1.0, endurance_s}, {}, {}});
    }
  }
  std::vector<NoBidder> left() {
    const TaskSet set = split(mission.arcs, 10.0, 1000);
    for (Winnings& member : members)
      if (states_claims(mission.auction.policy))
        member.path = path_of(member.taken, set, member.uav, mission.auction, transit);
    return no_bidders(members, set, mission.auction, transit);
  }
  std::vector<std::string> texts() {
    std::vector<std::string> texts;
    for (const NoBidder& one : left()) texts.push_back(to_text(one));
    return texts;
  }
  Mission mission;
  std::vector<Winnings> members;
  StraightTransit transit;
};

TEST(NoBidders, AreNoneWhereEverythingWasWon) {
  Line line(2, {1000, 1000});
  line.members[0].taken = {{0}, {1}};
  line.members[1].taken = {{3}, {2}};
  EXPECT_THAT(line.left(), IsEmpty());
}

TEST(NoBidders, NameThePayloadThatNobodyCarries) {
  Line line(2, {1000, 1000});
  line.mission.arcs[1].payload = Payload::camera;
  for (Winnings& member : line.members) member.uav.payload = Payload::lidar;
  line.members[0].taken = {{0}, {1}};
  EXPECT_THAT(line.texts(),
              ElementsAre("arc 1, 0.0 to 20.0 m: no bidder: needs a camera, nobody carries one"));
}

TEST(NoBidders, NameTheEnduranceThatNobodyHas) {
  Line line(2, {150, 219.95, 210});
  line.members[0].taken = {{0}, {1}};
  EXPECT_THAT(line.texts(), ElementsAre("arc 1, 0.0 to 20.0 m: no bidder: needs 240.0 s, best "
                                        "endurance 219.9 s (agent 2)"));
}

TEST(NoBidders, CompareTheEnduranceOfWhoComesNearestWithItsOwnSpeed) {
  Line line(2, {105, 200});
  line.members[0].uav.speed_mps = 2;  // needs 120 s; agent 2, which lasts longer, 240 s
  line.members[0].taken = {{0}, {1}};
  EXPECT_THAT(line.texts(), ElementsAre("arc 1, 0.0 to 20.0 m: no bidder: needs 120.0 s, best "
                                        "endurance 105.0 s (agent 1)"));
}

TEST(NoBidders, DoNotCountTheEnduranceOfWhoCarriesSomethingElse) {
  Line line(2, {1000, 150});
  line.mission.arcs[1].payload = Payload::camera;
  line.members[0].uav.payload = Payload::lidar;
  line.members[0].taken = {{0}, {1}};
  EXPECT_THAT(line.texts(), ElementsAre("arc 1, 0.0 to 20.0 m: no bidder: needs 240.0 s, best "
                                        "endurance 150.0 s (agent 2)"));
}

TEST(NoBidders, SayHowMuchEnduranceIsLackingAfterAllThatWasWon) {
  Line line(2, {235, 239});
  line.members[0].taken = {{2}, {0}, {1}};  // out to 110 m and back: 220 s
  EXPECT_THAT(line.texts(), ElementsAre("arc 1, 10.0 to 20.0 m: no bidder: needs 240.0 s, best "
                                        "endurance 239.0 s (agent 2)"));
  line.members[1].uav.endurance_s = 245;
  line.members[1].taken = {};
  line.mission.arcs[0].waypoints.back().position_m = Vec3(0, 20, 0);
  line.members[0].taken = {{2}};
  line.members[1].taken = {{0}, {1}};  // out to y = 20 m and back, and then 240 s more
  EXPECT_THAT(line.texts(), ElementsAre("arc 1, 10.0 to 20.0 m: no bidder: nobody has endurance "
                                        "left for it: agent 1 lacks 5.0 s"));
}

TEST(NoBidders, DoNotPretendToKnowTheOrderBehindATable) {
  Line line(2, {1000});
  line.members[0].uav.endurance_s = 250;
  line.mission.auction.policy = PolicyKind::cbba;
  line.members[0].taken = {{0}, {1}};
  EXPECT_THAT(line.texts(), ElementsAre("arc 1, 0.0 to 20.0 m: no bidder: nobody has endurance "
                                        "left for it"));
}

TEST(NoBidders, NameTheBundleLimitWhereItIsAllThatIsInTheWay) {
  Line line(2, {1000, 150});
  line.mission.auction.bundle_limit = 2;
  line.members[0].taken = {{0}, {1}};
  EXPECT_THAT(line.texts(), ElementsAre("arc 1, 0.0 to 20.0 m: no bidder: all who could fly it "
                                        "have 2 tasks, the bundle limit"));
}

TEST(NoBidders, AreOneWhereNeighboursAreLeftForTheSameReason) {
  Line line(3, {231});  // arc 1's first piece can be flown alone, the second not, nor arc 2
  line.members[0].taken = {{0}};
  const std::vector<NoBidder> left = line.left();
  ASSERT_EQ(left.size(), 4u);
  EXPECT_EQ(left[0].arc, ArcId{0});
  EXPECT_EQ(left[0].from_m, 10);
  EXPECT_EQ(left[1].why, NoBidderReason::endurance_left);
  EXPECT_EQ(left[1].to_m, 10);
  EXPECT_EQ(left[2].why, NoBidderReason::endurance);
  EXPECT_EQ(left[2].from_m, 10);
  EXPECT_EQ(left[3].arc, ArcId{2});
  EXPECT_EQ(left[3].to_m, 20);
  EXPECT_EQ(left[3].needed_s, 440);
}

/// The auction with limits is the sequential greedy one, and what that leaves is reported.
TEST(NoBidders, AreWhatTheSequentialGreedyAllocationLeaves) {
  std::size_t unowned = 0, owned = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Dice dice(seed);
    Mission mission = random_mission(seed, 3, 8);
    for (Arc& arc : mission.arcs) arc.payload = static_cast<Payload>(dice.below(3));
    for (Uav& uav : mission.fleet) {
      uav.endurance_s = 90 + 100 * dice.unit();
      uav.payload = static_cast<Payload>(dice.below(3));
    }
    Fleet fleet(mission, {.loss = 0.3, .duplicate = 0.2}, seed);
    ASSERT_TRUE(fleet.run(60'000'000'000));
    const TaskSet& set = fleet.agent({1}).tasks();
    const auto expected = sequential_greedy(mission, set, fleet.living());
    const Agreement& agreed = *fleet.agreement({1});
    std::size_t stretch = 0;
    for (const Task& task : set.tasks) {
      const std::uint32_t j = task.id.value;
      ASSERT_EQ(agreed.winners[j].winner, expected[j].winner) << "task " << j;
      owned += expected[j].winner.has_value();
      if (expected[j].winner) continue;
      ++unowned;
      while (stretch < agreed.left.size() &&
             (agreed.left[stretch].arc != task.arc || agreed.left[stretch].to_m <= task.from_m))
        ++stretch;
      ASSERT_LT(stretch, agreed.left.size()) << "no reason for task " << j;
      EXPECT_LE(agreed.left[stretch].from_m, task.from_m);
      if (agreed.left[stretch].nearest) {
        EXPECT_GT(agreed.left[stretch].needed_s, agreed.left[stretch].endurance_s);
      }
    }
    for (const AgentId id : fleet.living()) EXPECT_EQ(fleet.agreement(id)->left, agreed.left);
  }
  EXPECT_GT(unowned, 50u);
  EXPECT_GT(owned, 50u);
}

}  // namespace
}  // namespace arcbid::testing
