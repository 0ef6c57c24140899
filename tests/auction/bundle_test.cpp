// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/auction/bundle.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>

#include "tests/auction/fleet.hpp"
#include "tests/auction/scripted_score.hpp"

namespace arcbid::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr AgentId self{2};

Bundle scripted(ScriptedScore::Gain gain, std::size_t tasks, std::uint32_t limit = 0,
                bool diminishing = true) {
  return Bundle(self, std::make_unique<ScriptedScore>(std::move(gain), diminishing), tasks, limit);
}

ScriptedScore::Gain fixed(std::vector<double> gains) {
  return [gains](TaskId j, const auto&) { return gains[j.value]; };
}

std::vector<std::uint32_t> tasks_of(const Bundle& bundle) {
  std::vector<std::uint32_t> tasks;
  for (const Claim& claim : bundle.claims()) tasks.push_back(claim.task.value);
  return tasks;
}

std::vector<double> bids_of(const Bundle& bundle) {
  std::vector<double> bids;
  for (const Claim& claim : bundle.claims()) bids.push_back(claim.bid);
  return bids;
}

/// A bundle on a real score, for one UAV of a random mission.
struct RealBundle {
  RealBundle(std::uint64_t seed, ScoreKind kind, std::uint32_t limit = 0)
      : mission(random_mission(seed, 3, 10)),
        set(split(mission.arcs, mission.auction.split_m, 1000)) {
    mission.auction.score = kind;
    const Uav& uav = mission.fleet[1];
    bundle.emplace(uav.id, make_score(set, uav, mission.auction, transit), set.tasks.size(), limit);
  }
  Mission mission;
  TaskSet set;
  StraightTransit transit;
  std::optional<Bundle> bundle;
};

/// Bids of agents 1 and 3, about half of them out of reach.
std::vector<Belief> random_rivals(const RealBundle& real, Dice& dice) {
  std::vector<Belief> rivals(real.set.tasks.size());
  for (Belief& rival : rivals)
    if (dice.unit() < 0.7) {
      const ScoreKind kind = real.mission.auction.score;
      const bool cost = kind == ScoreKind::minimax || kind == ScoreKind::minimax_long_first ||
                        kind == ScoreKind::minisum;
      rival = {AgentId{dice.unit() < 0.5 ? 1u : 3u}, (cost ? -200 : 10) * dice.unit()};
    }
  return rivals;
}

constexpr ScoreKind all_scores[] = {
    ScoreKind::minimax,           ScoreKind::minisum,           ScoreKind::independent,
    ScoreKind::discounted_append, ScoreKind::discounted_insert, ScoreKind::discounted_insert_warped,
    ScoreKind::minimax_long_first};

TEST(Beats, AnyBidWinsAgainstNone) {
  EXPECT_TRUE(beats(-1e300, {9}, {}));
  EXPECT_TRUE(beats(0, {9}, {}));
}

TEST(Beats, ComparesBidsExactly) {
  const Belief rival{AgentId{1}, 1.0};
  EXPECT_TRUE(beats(std::nextafter(1.0, 2.0), {2}, rival));
  EXPECT_FALSE(beats(std::nextafter(1.0, 0.0), {2}, rival));
  EXPECT_FALSE(beats(std::nextafter(1.0, 0.0), {1}, {AgentId{2}, 1.0}));
}

TEST(Beats, GivesATieToTheLowerId) {
  EXPECT_TRUE(beats(1.0, {1}, {AgentId{2}, 1.0}));
  EXPECT_FALSE(beats(1.0, {2}, {AgentId{1}, 1.0}));
  EXPECT_FALSE(beats(1.0, {2}, {AgentId{2}, 1.0}));
}

TEST(Bundle, TakesTheHighestGainFirstAndTheLowestIdOnTies) {
  Bundle bundle = scripted(fixed({3, 7, 5, 7, 5}), 5);
  bundle.extend(std::vector<Belief>(5));
  EXPECT_THAT(tasks_of(bundle), ElementsAre(1, 3, 2, 4, 0));
  EXPECT_THAT(bids_of(bundle), ElementsAre(7, 7, 5, 5, 3));
}

TEST(Bundle, TakesOnlyWhatItWins) {
  Bundle bundle = scripted(fixed({5, 5, 5, 5}), 4);
  bundle.extend({{AgentId{1}, 5.0}, {AgentId{3}, 5.0}, {AgentId{1}, 4.9}, {AgentId{3}, 5.1}});
  EXPECT_THAT(tasks_of(bundle), ElementsAre(1, 2));
}

TEST(Bundle, StopsAtItsLimit) {
  Bundle bundle = scripted(fixed({1, 2, 3, 4}), 4, 2);
  bundle.extend(std::vector<Belief>(4));
  EXPECT_THAT(tasks_of(bundle), ElementsAre(3, 2));
  bundle.extend(std::vector<Belief>(4));
  EXPECT_EQ(bundle.claims().size(), 2u);
}

TEST(Bundle, NeverBidsAboveItsLowestBid) {
  // A task in the path makes the others dearer: gains grow, bids must not.
  Bundle bundle = scripted(
      [](TaskId j, const auto& path) { return 5.0 - j.value + 3.0 * path.size(); }, 3, 0, false);
  bundle.extend(std::vector<Belief>(3));
  EXPECT_THAT(tasks_of(bundle), ElementsAre(0, 1, 2));
  EXPECT_THAT(bids_of(bundle), ElementsAre(5, 5, 5));
}

TEST(Bundle, ChoosesByTheTrueGainAmongEqualWarpedBids) {
  Bundle bundle = scripted(
      [](TaskId j, const auto& path) {
        if (path.empty()) return j.value == 0 ? 5.0 : 1.0;
        return j.value == 1 ? 7.0 : 9.0;
      },
      3, 0, false);
  bundle.extend(std::vector<Belief>(3));
  EXPECT_THAT(tasks_of(bundle), ElementsAre(0, 2, 1));
}

TEST(Bundle, DoesNotTakeATaskThatOnlyItsTrueGainWouldWin) {
  Bundle bundle = scripted(
      [](TaskId j, const auto& path) {
        return path.empty() && j.value == 1 ? 1.0 : 5.0 + 4 * j.value;
      },
      2, 0, false);
  bundle.extend({{}, {AgentId{1}, 6.0}});  // worth 9 once task 0 is in, but 5 is all it may bid
  EXPECT_THAT(tasks_of(bundle), ElementsAre(0));
}

TEST(Bundle, AsksAgainForALostTaskWhereGainsMayRise) {
  const auto gain = [](TaskId j, const auto& path) {
    return j.value == 0 ? 10.0 : (path.empty() ? 1.0 : 8.0);
  };
  Bundle bundle = scripted(gain, 2, 0, false);
  bundle.extend({{}, {AgentId{1}, 5.0}});
  EXPECT_THAT(tasks_of(bundle), ElementsAre(0, 1));
}

TEST(Bundle, StartsAfreshWithEveryExtension) {
  Bundle bundle = scripted(fixed({10, 4}), 2);
  bundle.extend({{}, {AgentId{1}, 5.0}});
  EXPECT_THAT(tasks_of(bundle), ElementsAre(0));
  bundle.extend({{}, {AgentId{1}, 3.0}});  // the rival of task 1 has lowered its bid
  EXPECT_THAT(tasks_of(bundle), ElementsAre(0, 1));
}

TEST(Bundle, IsTheSameWhenGainsAreFirstOnlyBounded) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    Dice dice(seed);
    std::vector<double> gains;
    std::vector<Belief> rivals;
    for (int j = 0; j < 8; ++j) {
      gains.push_back(static_cast<double>(dice.below(6)));  // few values, many ties
      rivals.push_back({AgentId{dice.unit() < 0.5 ? 1u : 3u}, static_cast<double>(dice.below(6))});
    }
    const auto gain = [gains](TaskId j, const auto& path) {
      return gains[j.value] - static_cast<double>(path.size() % 2 * (j.value % 3));
    };
    const auto built = [&](double slack) {
      Bundle bundle(self, std::make_unique<ScriptedScore>(gain, false, slack), 8, 0);
      bundle.extend(rivals);
      return bundle.claims();
    };
    EXPECT_EQ(built(2.5), built(0)) << "seed " << seed;
  }
}

TEST(Bundle, ExtendsNoFurtherWhenAskedTwice) {
  for (const ScoreKind kind : all_scores)
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      RealBundle real(seed, kind, seed % 2 ? 0 : 4);
      Dice dice(seed);
      const auto rivals = random_rivals(real, dice);
      real.bundle->extend(rivals);
      const auto claims = real.bundle->claims();
      const auto path = real.bundle->path();
      ASSERT_FALSE(claims.empty());
      real.bundle->extend(rivals);
      EXPECT_EQ(real.bundle->claims(), claims);
      EXPECT_EQ(real.bundle->path(), path);
    }
}

TEST(Bundle, HoldsTheSameTasksAsItsPathAndBidsThatNeverRise) {
  for (const ScoreKind kind : all_scores)
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      RealBundle real(seed, kind);
      Dice dice(seed);
      const auto rivals = random_rivals(real, dice);
      real.bundle->extend(rivals);
      std::vector<TaskId> claimed, flown;
      for (const Claim& claim : real.bundle->claims()) {
        claimed.push_back(claim.task);
        EXPECT_TRUE(beats(claim.bid, {2}, rivals[claim.task.value]));
      }
      for (const PathStop& stop : real.bundle->path()) flown.push_back(stop.task);
      EXPECT_THAT(flown, ::testing::UnorderedElementsAreArray(claimed));
      const auto bids = bids_of(*real.bundle);  // RealBundle warps whatever the score
      EXPECT_TRUE(std::is_sorted(bids.rbegin(), bids.rend()));
    }
}

/// Some rivals bid anew, some give up.
void change_some(std::vector<Belief>& rivals, const std::vector<Belief>& others, Dice& dice) {
  const double share = dice.unit() < 0.5 ? 0.05 : 0.4;
  for (std::size_t j = 0; j < rivals.size(); ++j)
    if (dice.unit() < share) rivals[j] = dice.unit() < 0.5 ? others[j] : Belief{};
}

TEST(Bundle, RebuildsToWhatABuildFromNothingGives) {
  for (const ScoreKind kind : all_scores)
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      const std::uint32_t limit = seed % 3 == 0 ? 5 : 0;
      RealBundle kept(seed, kind, limit);
      Dice dice(seed);
      auto rivals = random_rivals(kept, dice);
      for (int change = 0; change < 25; ++change) {
        SCOPED_TRACE(fmt::format("{}, seed {}, change {}", name_of(kind), seed, change));
        const auto before = kept.bundle->claims();
        if (dice.unit() < 0.2) kept.bundle->release_from(dice.below(before.size() + 1));
        const auto released = kept.bundle->claims();
        const bool changed = kept.bundle->rebuild(rivals);
        RealBundle fresh(seed, kind, limit);
        fresh.bundle->extend(rivals);
        ASSERT_EQ(kept.bundle->claims(), fresh.bundle->claims());
        ASSERT_EQ(kept.bundle->path(), fresh.bundle->path());
        ASSERT_EQ(changed, kept.bundle->claims() != released);
        change_some(rivals, random_rivals(kept, dice), dice);
      }
    }
}

TEST(Bundle, RebuildsAmongTiesAsFromNothing) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Dice dice(seed);
    std::vector<double> gains;
    for (int j = 0; j < 8; ++j) gains.push_back(static_cast<double>(dice.below(6)));
    const auto gain = [gains](TaskId j, const auto& path) {
      return gains[j.value] - static_cast<double>(path.size() % 2 * (j.value % 3));
    };
    Bundle kept(self, std::make_unique<ScriptedScore>(gain, false), 8, seed % 2 ? 4 : 0);
    std::vector<Belief> rivals(8);
    for (int change = 0; change < 20; ++change) {
      kept.rebuild(rivals);
      Bundle fresh(self, std::make_unique<ScriptedScore>(gain, false), 8, seed % 2 ? 4 : 0);
      fresh.extend(rivals);
      ASSERT_EQ(kept.claims(), fresh.claims()) << "seed " << seed << ", change " << change;
      rivals[dice.below(8)] = {AgentId{dice.unit() < 0.5 ? 1u : 3u},
                               static_cast<double>(dice.below(6))};
      if (dice.unit() < 0.3) rivals[dice.below(8)] = {};
    }
  }
}

TEST(Bundle, BidsItsTrueGainsWhenAskedTo) {
  Bundle bundle(self,
                std::make_unique<ScriptedScore>(
                    [](TaskId, const auto& path) { return 5.0 + double(path.size()); }, false),
                3, 0, Bundle::Bids::true_gains);
  bundle.extend(std::vector<Belief>(3));
  EXPECT_THAT(bids_of(bundle), ElementsAre(5, 6, 7));
}

TEST(Bundle, ReleasesExactlyTheTail) {
  for (const ScoreKind kind : all_scores) {
    RealBundle whole(3, kind);
    const std::vector<Belief> nobody(whole.set.tasks.size());
    whole.bundle->extend(nobody);
    const auto claims = whole.bundle->claims();
    for (std::size_t keep = 0; keep <= claims.size(); ++keep) {
      RealBundle real(3, kind);
      real.bundle->extend(nobody);
      real.bundle->release_from(keep);
      EXPECT_EQ(real.bundle->claims(),
                std::vector<Claim>(claims.begin(), claims.begin() + long(keep)));
      std::vector<PathStop> path = whole.bundle->path();
      std::erase_if(path, [&](const PathStop& stop) {
        return std::any_of(claims.begin() + long(keep), claims.end(),
                           [&](const Claim& claim) { return claim.task == stop.task; });
      });
      EXPECT_EQ(real.bundle->path(), path) << "the path lost its order";
    }
  }
}

TEST(Bundle, ReleasesNothingBeyondItsEnd) {
  Bundle bundle = scripted(fixed({1, 2}), 2);
  bundle.release_from(0);
  EXPECT_THAT(bundle.claims(), IsEmpty());
  bundle.extend(std::vector<Belief>(2));
  bundle.release_from(7);
  EXPECT_EQ(bundle.claims().size(), 2u);
}

TEST(Bundle, WarpsAgainstWhatItKept) {
  Bundle bundle = scripted([](TaskId, const auto& path) { return 5.0 + path.size(); }, 3, 0, false);
  bundle.extend(std::vector<Belief>(3));
  bundle.release_from(1);
  bundle.extend(std::vector<Belief>(3));
  EXPECT_THAT(bids_of(bundle), ElementsAre(5, 5, 5));
}

}  // namespace
}  // namespace arcbid::testing
