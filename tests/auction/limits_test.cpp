// SPDX-License-Identifier: GPL-3.0-or-later
// What a UAV has not the payload or the endurance for is never bid for: the scores and the bundles
// against a plain search among the places that it can fly.
#include "core/auction/limits.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/auction/bid_audit.hpp"
#include "core/auction/policy.hpp"
#include "tests/auction/fleet.hpp"

namespace arcbid::testing {
namespace {

using Path = std::vector<PathStop>;

bool appends(ScoreKind kind) {
  return kind == ScoreKind::independent || kind == ScoreKind::discounted_append;
}

/// A UAV with half the endurance that all tasks together would take, and a payload; tasks that need
/// one or the other.
struct Limited {
  Limited(std::uint64_t seed, ScoreKind kind) : dice(seed), mission(random_mission(seed, 3, 9)) {
    for (Arc& arc : mission.arcs) arc.payload = static_cast<Payload>(dice.below(3));
    for (Uav& one : mission.fleet) {
      one.payload = static_cast<Payload>(dice.below(3));
      one.endurance_s = 80 + 200 * dice.unit();
    }
    mission.auction.score = kind;
    set = split(mission.arcs, mission.auction.split_m, 1000);
    set.return_home = seed % 4 > 0;
    uav = mission.fleet[1];
  }
  double metres(const Path& path) const {
    double sum = 0;
    Vec3 at = uav.home_m;
    for (const PathStop& stop : path) {
      const Task& task = set.tasks[stop.task.value];
      sum += ((stop.reversed ? task.last_m : task.first_m) - at).norm() + task.length_m();
      at = stop.reversed ? task.first_m : task.last_m;
    }
    return set.return_home ? sum + (at - uav.home_m).norm() : sum;
  }
  double reward(const Path& path) const {
    double sum = 0, time_s = 0;
    Vec3 at = uav.home_m;
    for (const PathStop& stop : path) {
      const Task& task = set.tasks[stop.task.value];
      time_s += (((stop.reversed ? task.last_m : task.first_m) - at).norm() + task.length_m()) /
                uav.speed_mps;
      sum += task.value * std::exp(-mission.auction.discount_per_s * time_s);
      at = stop.reversed ? task.first_m : task.last_m;
    }
    return sum;
  }
  double gain(const Path& path, const Path& longer, PathStop stop) const {
    const double own_m = set.tasks[stop.task.value].length_m();
    switch (mission.auction.score) {
      case ScoreKind::minimax:
        return -metres(longer) / uav.speed_mps;
      case ScoreKind::minimax_long_first:
        return (2 * own_m - metres(longer)) / uav.speed_mps;
      case ScoreKind::minisum:
        return (metres(path) - metres(longer)) / uav.speed_mps;
      case ScoreKind::independent:
        return reward({stop});
      default:
        return reward(longer) - reward(path);
    }
  }
  Bundle bundle() const { return make_bundle(set, uav, mission.auction, transit); }
  std::vector<Belief> rivals() {
    std::vector<Belief> rivals(set.tasks.size());
    for (Belief& rival : rivals)
      if (dice.unit() < 0.4) rival = {AgentId{3}, 200 * dice.unit() - 150};
    return rivals;
  }
  bool carries(TaskId task) const {
    const Payload needs = mission.arcs[set.tasks[task.value].arc.value].payload;
    return needs == Payload::any || uav.payload == Payload::any || needs == uav.payload;
  }
  /// Every way to take the task into the path that the UAV can fly.
  template <class See>
  void each_way(const Path& path, TaskId task, bool at_end, See see) const {
    for (std::size_t l = at_end ? path.size() : 0; carries(task) && l <= path.size(); ++l)
      for (const bool reversed : {false, true}) {
        Path longer = path;
        longer.insert(longer.begin() + static_cast<std::ptrdiff_t>(l), {task, reversed});
        if (metres(longer) <= *uav.endurance_s * uav.speed_mps)
          see(longer, PathStop{task, reversed});
      }
  }

  Dice dice;
  Mission mission;
  TaskSet set;
  Uav uav;
  StraightTransit transit;
};

class Limits : public ::testing::TestWithParam<ScoreKind> {};

INSTANTIATE_TEST_SUITE_P(All, Limits,
                         ::testing::Values(ScoreKind::minimax, ScoreKind::minisum,
                                           ScoreKind::independent, ScoreKind::discounted_append,
                                           ScoreKind::discounted_insert,
                                           ScoreKind::discounted_insert_warped,
                                           ScoreKind::minimax_long_first),
                         [](const auto& kind) {
                           std::string name(name_of(kind.param));
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

TEST_P(Limits, LeaveTheBestWayAmongThoseThatCanBeFlown) {
  std::size_t flyable = 0, not_flyable = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Limited one(seed, GetParam());
    const auto score = make_score(one.set, one.uav, one.mission.auction, one.transit);
    Path path;
    std::vector<bool> in_path(one.set.tasks.size());
    for (int step = 0; step < 12; ++step) {
      for (const Task& task : one.set.tasks) {
        if (in_path[task.id.value]) continue;
        const double bound = score->bound(task.id).gain;
        const Insertion where = score->best(task.id);
        double expected = unflyable;
        one.each_way(path, task.id, appends(GetParam()), [&](const Path& longer, PathStop stop) {
          expected = std::max(expected, one.gain(path, longer, stop));
        });
        EXPECT_GE(bound, where.gain);
        ASSERT_EQ(where.gain == unflyable, expected == unflyable) << "seed " << seed;
        (expected == unflyable ? not_flyable : flyable) += 1;
        if (expected == unflyable) continue;
        ASSERT_NEAR(where.gain, expected, 1e-9) << "seed " << seed;
        Path longer = path;
        longer.insert(longer.begin() + where.position, {task.id, where.reversed});
        ASSERT_LE(one.metres(longer), *one.uav.endurance_s * one.uav.speed_mps + 1e-6);
      }
      const TaskId more{static_cast<std::uint32_t>(one.dice.below(one.set.tasks.size()))};
      const Insertion where = in_path[more.value] ? Insertion{unflyable} : score->best(more);
      if (where.gain == unflyable) continue;
      score->insert(more, where);
      path = score->path();
      in_path[more.value] = true;
    }
  }
  EXPECT_GT(flyable, 500u);
  EXPECT_GT(not_flyable, 500u);
}

/// What makes gains that diminish go on doing so: where a task cannot be flown, a longer path does
/// not make it so.
TEST_P(Limits, OnlyGrowTighter) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Limited one(seed, GetParam());
    const auto score = make_score(one.set, one.uav, one.mission.auction, one.transit);
    std::vector<bool> lost(one.set.tasks.size());
    for (const Task& more : one.set.tasks) {
      for (std::uint32_t j = more.id.value; j < lost.size(); ++j) {
        const bool is_flyable = score->best({j}).gain > unflyable;
        EXPECT_FALSE(is_flyable && lost[j]) << "seed " << seed << " task " << j;
        lost[j] = !is_flyable;
      }
      if (lost[more.id.value]) continue;
      score->insert(more.id, score->best(more.id));
    }
  }
}

/// One task from x = 10 to 14 at 2 m/s: 14 s, home to home.
struct OneTask {
  OneTask(ScoreKind kind) {
    set.tasks = {{{0}, {0}, 0, 4, Vec3(10, 0, 0), Vec3(14, 0, 0), 4}};
    settings.score = kind;
  }
  bool is_flown(std::optional<double> endurance_s) {
    const Uav uav{{1}, Vec3::Zero(), 2.0, endurance_s};
    return make_score(set, uav, settings, transit)->best({0}).gain > unflyable;
  }
  TaskSet set;
  AuctionSettings settings;
  StraightTransit transit;
};

TEST_P(Limits, LetATourTakeJustAsLongAsTheUavLasts) {
  OneTask one(GetParam());
  EXPECT_TRUE(one.is_flown(std::nullopt));
  EXPECT_TRUE(one.is_flown(14.0));
  EXPECT_TRUE(one.is_flown(14.0 * (1 - 1e-12))) << "legs may be added up in another order";
  EXPECT_FALSE(one.is_flown(14.0 * (1 - 1e-6)));
  one.set.return_home = false;
  EXPECT_TRUE(one.is_flown(7.0)) << "where nobody returns, nobody needs the way home";
  EXPECT_FALSE(one.is_flown(6.9));
}

TEST_P(Limits, DoNotMakeTheAuditRefuseWhatABundleReallyHolds) {
  std::size_t claims = 0;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    Limited one(seed, GetParam());
    one.set.return_home = true;
    Bundle rebuilt = one.bundle(), kept = one.bundle();
    BidAudit audit(one.set, one.mission.fleet, one.mission.auction, one.transit);
    for (int step = 0; step < 20; ++step) {
      const std::vector<Belief> rivals = one.rivals();
      rebuilt.rebuild(rivals);
      kept.release_from(kept.still_won(rivals));
      kept.extend(rivals);
      for (const Bundle* bundle : {&rebuilt, &kept}) {
        EXPECT_EQ(audit.refusal({{2}, {9, false, 1}, Claims{bundle->claims()}}), std::nullopt);
        claims += bundle->claims().size();
        EXPECT_LE(one.metres(bundle->path()), *one.uav.endurance_s * one.uav.speed_mps + 1e-6);
      }
    }
  }
  EXPECT_GT(claims, 100u);
}

TEST_P(Limits, HoldWhateverWasBuiltBefore) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    Limited one(seed, GetParam());
    Bundle bundle = one.bundle();
    for (int step = 0; step < 20; ++step) {
      const std::vector<Belief> rivals = one.rivals();
      bundle.rebuild(rivals);
      Bundle fresh = one.bundle();
      fresh.rebuild(rivals);
      ASSERT_EQ(bundle.claims(), fresh.claims()) << "seed " << seed << " step " << step;
      ASSERT_EQ(bundle.path(), fresh.path());
    }
  }
}

}  // namespace
}  // namespace arcbid::testing
