// SPDX-License-Identifier: GPL-3.0-or-later
// The checker of exchanges is shown what must never come of an agreement, and must say so.
#include <gtest/gtest.h>

#include "sim/world/checkers/exchanges.hpp"
#include "sim/world/run.hpp"
#include "sim/world/settings_file.hpp"

namespace arcbid::testing {
namespace {

/// Two agents at the ends of a line, three arcs of one piece each; the third is nobody's.
class ExchangeCheckerTest : public ::testing::Test {
 protected:
  ExchangeCheckerTest() {
    mission.fleet = {{{1}, Vec3(0, 0, 0), 1}, {{2}, Vec3(100, 0, 0), 1}};
    for (std::uint32_t m = 0; m < 3; ++m) {
      const Vec3 first(20 + 30 * m, 0, 0), last = first + Vec3(5, 0, 0);
      mission.arcs.push_back(
          {{m}, ArcKind::outline, {{first, Vec3::UnitZ()}, {last, Vec3::UnitZ()}}});
    }
    mission.auction.split_m = 5;
    mission.auction.trades = TradesKind::cheap;
    pieces = cut(mission);
    proof.winners = {{AgentId{1}, -50}, {AgentId{2}, -60}, {std::nullopt, 0}};
  }
  /// Shows it that the two fly these tasks.
  void fly(const std::vector<TaskId>& one, const std::vector<TaskId>& two) {
    FleetShare share{{{1}, {2}}, {{}, {}}, 1};
    for (const TaskId task : one) share.paths[0].push_back({task, false});
    for (const TaskId task : two) share.paths[1].push_back({task, false});
    checker.after(1, proof, share);
  }
  std::string said() const { return findings.found().empty() ? "" : findings.found().back().what; }

  Mission mission;
  std::vector<Stretch> pieces;
  StraightTransit transit;
  Findings findings;
  Agreement proof{77, 1, {{1}, {2}}, {}, {}, {}, {}};
  ExchangeChecker checker{mission, pieces, transit, findings};
};

TEST_F(ExchangeCheckerTest, FindsNothingInAGoodExchange) {
  fly({{1}}, {{0}});
  fly({{1}}, {{0}});
  EXPECT_EQ(said(), "");
}

TEST_F(ExchangeCheckerTest, SeesATaskThatTwoFly) {
  fly({{0}, {1}}, {{0}});
  EXPECT_EQ(said(), "task 0 is flown by 2 after exchanges");
}

TEST_F(ExchangeCheckerTest, SeesATaskThatNobodyFlies) {
  fly({}, {{0}});
  EXPECT_EQ(said(), "task 1 is flown by 0 after exchanges");
}

TEST_F(ExchangeCheckerTest, SeesATaskThatNobodyWon) {
  fly({{0}}, {{1}, {2}});
  EXPECT_EQ(said(), "task 2 is flown by 1 after exchanges");
}

TEST_F(ExchangeCheckerTest, SeesTwoWhoComeToDifferentThings) {
  fly({{1}}, {{0}});
  fly({{0}}, {{1}});
  EXPECT_EQ(said(), "two who agreed under 000000000000004d exchange differently");
}

TEST_F(ExchangeCheckerTest, SeesAFlightThatIsTooLong) {
  mission.fleet[1].endurance_s = 159;
  fly({{1}}, {{0}});  // 100 m there, 20 m from home, and back
  EXPECT_EQ(said(), "agent 2 flies 160 s, its endurance is 159");
}

TEST_F(ExchangeCheckerTest, SeesAMissingPayload) {
  mission.arcs[0].payload = Payload::camera;
  mission.fleet[1].payload = Payload::lidar;
  fly({{1}}, {{0}});
  EXPECT_EQ(said(), "agent 2 has no payload for task 0");
}

TEST_F(ExchangeCheckerTest, SeesABundleOverItsLimit) {
  mission.auction.bundle_limit = 1;
  fly({{0}, {1}}, {});
  EXPECT_EQ(said(), "agent 1 flies 2 tasks, its limit is 1");
}

TEST_F(ExchangeCheckerTest, SeesAnExchangeThatMakesItSlower) {
  checker.compare(1, 100, 100);
  EXPECT_EQ(said(), "");
  checker.compare(1, 100, 100.1);
  EXPECT_EQ(said(), "the slowest takes 100.1 s after exchanges, 100 s before");
}

TEST_F(ExchangeCheckerTest, WantsEachAgreementTwice) {
  EXPECT_TRUE(checker.wants(proof));
  fly({{1}}, {{0}});
  EXPECT_TRUE(checker.wants(proof));
  fly({{1}}, {{0}});
  EXPECT_FALSE(checker.wants(proof));
  proof.view_hash = 78;
  EXPECT_TRUE(checker.wants(proof));
  mission.auction.trades = TradesKind::off;
  EXPECT_FALSE(checker.wants(proof));
}

TEST(ExchangeWorlds, HoldAndAreBetterThanWithoutExchanges) {
  WorldSettings settings = load_worlds(std::string(ARCBID_SOURCE_DIR) + "/configs/sim_trades.yaml");
  double with_s = 0, without_s = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    WorldSpec spec = make_world(settings, seed);
    const WorldResult with = run_world(spec);
    EXPECT_TRUE(with.agreed && with.violations.empty()) << "seed " << seed;
    spec.mission.auction.trades = TradesKind::off;
    const WorldResult without = run_world(spec);
    with_s += with.makespan_s;
    without_s += without.makespan_s;
  }
  EXPECT_LT(with_s, 0.95 * without_s);
}

}  // namespace
}  // namespace arcbid::testing
