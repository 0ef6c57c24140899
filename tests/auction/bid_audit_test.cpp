// SPDX-License-Identifier: GPL-3.0-or-later
// Bids follow from the mission: true ones pass whatever the score, false ones do not.
#include "core/auction/bid_audit.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "core/auction/policy.hpp"
#include "tests/auction/fleet.hpp"

namespace arcbid::testing {
namespace {

using ::testing::HasSubstr;

constexpr std::array scores{ScoreKind::minimax,           ScoreKind::minisum,
                            ScoreKind::independent,       ScoreKind::discounted_append,
                            ScoreKind::discounted_insert, ScoreKind::discounted_insert_warped,
                            ScoreKind::minimax_long_first};

/// A mission, and the second of its three agents with all that it states.
struct Audited {
  explicit Audited(std::uint64_t seed, ScoreKind score, PolicyKind policy = PolicyKind::claims)
      : mission(random_mission(seed, 3, 10)),
        set(split(mission.arcs, mission.auction.split_m, 1000)),
        dice(seed) {
    mission.auction.score = score;
    mission.auction.policy = policy;
    bundle.emplace(make_bundle(set, mission.fleet[1], mission.auction, transit));
    audit.emplace(fresh_audit());
  }
  BidAudit fresh_audit() const { return BidAudit(set, mission.fleet, mission.auction, transit); }
  double alone(std::size_t member, std::uint32_t task) const {
    return make_score(set, mission.fleet[member], mission.auction, transit)->best({task}).gain;
  }
  /// Bids of the others, near the agent's own, as they come and go in an auction.
  std::vector<Belief> random_rivals() {
    std::vector<Belief> rivals(set.tasks.size());
    for (std::uint32_t j = 0; j < rivals.size(); ++j)
      if (dice.unit() < 0.5) rivals[j] = {AgentId{3}, alone(2, j) * (0.5 + dice.unit())};
    return rivals;
  }
  Claims rebuilt() {
    bundle->rebuild(random_rivals());
    return {bundle->claims()};
  }
  Claims kept() {
    const auto rivals = random_rivals();
    bundle->release_from(bundle->still_won(rivals));
    bundle->extend(rivals);
    return {bundle->claims()};
  }
  std::optional<std::string> refusal(StatementBody body) {
    return audit->refusal({{2}, {9, false, 1}, std::move(body)});
  }
  /// A table in which one belief is held.
  std::optional<std::string> refusal(std::uint32_t task, Belief belief) {
    Table table{std::vector<Belief>(set.tasks.size()), std::vector<std::uint64_t>(3)};
    table.beliefs[task] = belief;
    return refusal(table);
  }

  Mission mission;
  TaskSet set;
  Dice dice;
  StraightTransit transit;
  std::optional<Bundle> bundle;
  std::optional<BidAudit> audit;
};

class Audit : public ::testing::TestWithParam<ScoreKind> {};

TEST_P(Audit, PassesWhatABundleReallyHolds) {
  std::size_t claims = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Audited rebuilding(seed, GetParam()), keeping(seed, GetParam());
    for (int step = 0; step < 20; ++step) {
      const Claims whole = rebuilding.rebuilt(), rest = keeping.kept();
      EXPECT_EQ(rebuilding.refusal(whole), std::nullopt) << *rebuilding.refusal(whole);
      EXPECT_EQ(keeping.refusal(rest), std::nullopt) << *keeping.refusal(rest);
      claims += whole.bundle.size() + rest.bundle.size();
    }
  }
  EXPECT_GT(claims, 1000u);
}

TEST_P(Audit, RecomputesRebuiltBidsToTheLastBit) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Audited one(seed, GetParam());
    BundleReplay replay =
        make_replay(one.set, one.mission.fleet[1], one.mission.auction, one.transit);
    for (int step = 0; step < 20; ++step) {
      const std::vector<Claim> claims = one.rebuilt().bundle;
      replay.keep(std::min<std::size_t>(one.dice.below(3), replay.claims().size()));
      std::size_t same = 0;
      while (same < std::min(replay.claims().size(), claims.size()) &&
             replay.claims()[same].task == claims[same].task)
        ++same;
      replay.keep(same);
      for (std::size_t n = same; n < claims.size(); ++n) replay.take(claims[n].task);
      EXPECT_EQ(replay.claims(), claims);
    }
  }
}

TEST_P(Audit, RefusesAnyOneFalseBid) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Audited one(seed, GetParam());
    const Claims truth = one.rebuilt();
    for (std::size_t n = 0; n < truth.bundle.size(); ++n)
      for (const double by : {1e9, 1e-3, -1e-3}) {
        Claims lie = truth;
        lie.bundle[n].bid += by;
        const auto reason = one.refusal(lie);
        ASSERT_TRUE(reason) << "a bid that is off by " << by;
        EXPECT_THAT(*reason, HasSubstr(fmt::format("agent 2 bids {} for task {}", lie.bundle[n].bid,
                                                   lie.bundle[n].task.value)));
        EXPECT_THAT(*reason, HasSubstr("where its path allows"));
        EXPECT_EQ(one.refusal(truth), std::nullopt) << "the next one is true";
      }
  }
}

TEST_P(Audit, SaysTheSameWhateverItWasAskedBefore) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Audited one(seed, GetParam());
    for (int step = 0; step < 40; ++step) {
      Claims claims = one.rebuilt();
      if (!claims.bundle.empty() && one.dice.unit() < 0.5)
        claims.bundle[one.dice.below(claims.bundle.size())].bid += 1;
      BidAudit fresh = one.fresh_audit();
      EXPECT_EQ(one.refusal(claims), fresh.refusal({{2}, {9, false, 1}, claims}));
    }
  }
}

TEST_P(Audit, RefusesBidsForWhatTheBidderCannotFly) {
  Mission mission = random_mission(3, 2, 4);
  mission.auction.score = GetParam();
  mission.arcs[1].payload = Payload::camera;
  mission.fleet[0].payload = Payload::lidar;
  mission.fleet[1].endurance_s = 10;
  const TaskSet set = split(mission.arcs, 1000.0, 1000);
  const StraightTransit transit;
  BidAudit audit(set, mission.fleet, mission.auction, transit);
  const auto claims = [&](std::uint32_t agent, std::uint32_t task, double bid) {
    return audit.refusal({{agent}, {9, false, 1}, Claims{{{{task}, bid}}}});
  };
  const auto table = [&](std::uint32_t agent, std::uint32_t task, double bid) {
    Table said{std::vector<Belief>(4), std::vector<std::uint64_t>(2)};
    said.beliefs[task] = {AgentId{agent}, bid};
    return audit.refusal({{1}, {9, false, 1}, said});
  };
  for (const double bid : {1e9, 1.0, -1e9, unflyable}) {
    for (const auto& reason : {claims(1, 1, bid), table(1, 1, bid)}) {
      ASSERT_TRUE(reason) << bid;
      EXPECT_THAT(*reason, HasSubstr("agent 1 bids for task 1, for which it has not the payload"));
    }
    for (const auto& reason : {claims(2, 0, bid), table(2, 0, bid)}) {
      ASSERT_TRUE(reason) << bid;
      EXPECT_THAT(*reason, HasSubstr("agent 2 bids for task 0"));
    }
  }
  const double true_bid =
      make_score(set, mission.fleet[0], mission.auction, transit)->best({0}).gain;
  EXPECT_EQ(claims(1, 0, true_bid), std::nullopt);
  EXPECT_EQ(table(1, 0, true_bid), std::nullopt);
}

TEST_P(Audit, OfATableAllowsWhatTheWinnerCanBidAndNoMore) {
  Audited one(4, GetParam(), PolicyKind::cbba);
  const auto tasks = static_cast<std::uint32_t>(one.set.tasks.size());
  for (const std::uint32_t member : {0u, 2u}) {
    double largest = -1e300;
    for (std::uint32_t j = 0; j < tasks; ++j) largest = std::max(largest, one.alone(member, j));
    for (std::uint32_t j = 0; j < tasks; ++j) {
      const double most = GetParam() == ScoreKind::minisum ? largest : one.alone(member, j);
      EXPECT_EQ(one.refusal(j, {AgentId{member + 1}, most}), std::nullopt);
      EXPECT_EQ(one.refusal(j, {AgentId{member + 1}, most - 1}), std::nullopt);
      const auto reason = one.refusal(j, {AgentId{member + 1}, most + 1e-3});
      ASSERT_TRUE(reason);
      EXPECT_THAT(*reason,
                  HasSubstr(fmt::format("agent 2 believes that agent {} bid", member + 1)));
      EXPECT_THAT(*reason, HasSubstr(fmt::format("for task {}, at most", j)));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(OfEveryScore, Audit, ::testing::ValuesIn(scores), [](const auto& p) {
  std::string name(name_of(p.param));
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(BidAudit, RefusesAnotherOrder) {
  Audited one(1, ScoreKind::minimax);
  Claims claims = one.rebuilt();
  ASSERT_GE(claims.bundle.size(), 2u);
  std::swap(claims.bundle[0], claims.bundle[1]);
  EXPECT_TRUE(one.refusal(claims));
}

TEST(BidAudit, ToleratesTheLastBitsOfAnotherHost) {
  Audited one(1, ScoreKind::discounted_append);
  Claims claims = one.rebuilt();
  ASSERT_FALSE(claims.bundle.empty());
  claims.bundle[0].bid *= 1 + 1e-12;
  EXPECT_EQ(one.refusal(claims), std::nullopt);
  claims.bundle[0].bid *= 1 + 1e-8;
  EXPECT_TRUE(one.refusal(claims));
}

TEST(BidAudit, IsOffWhereTheMissionSaysSo) {
  Audited one(1, ScoreKind::minimax);
  one.mission.auction.audit_bids = false;
  EXPECT_EQ(one.refusal(Claims{{{{0}, 1e9}}}), std::nullopt);
}

TEST(BidAudit, SparesTombstones) {
  Audited one(1, ScoreKind::minimax);
  EXPECT_EQ(one.audit->refusal({{2}, {9, true, 1}, Claims{}}), std::nullopt);
}

}  // namespace
}  // namespace arcbid::testing
