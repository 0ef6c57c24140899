// SPDX-License-Identifier: GPL-3.0-or-later
// The incremental scores against a full recomputation of the path. Transits on the integer lattice
// make all distances exact, so that ties are true ties and gains must agree to the last bit.
#include "core/auction/score.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>

#include "tests/auction/fleet.hpp"

namespace arcbid {

std::ostream& operator<<(std::ostream& out, const Insertion& where) {
  return out << where.gain << " at " << where.position << (where.reversed ? " reversed" : "");
}

namespace testing {
namespace {

using Path = std::vector<PathStop>;

/// Along the axes; climbing costs twice. Not symmetric, and exact on integers.
class LatticeTransit final : public Transit {
 public:
  double length_m(const Vec3& from, const Vec3& to) const override {
    const Vec3 d = to - from;
    return std::abs(d.x()) + std::abs(d.y()) + (d.z() > 0 ? 2 * d.z() : -d.z());
  }
  std::vector<Vec3> way(const Vec3& from, const Vec3& to) const override { return {from, to}; }
};

/// Tasks between points of a 5 x 5 x 2 lattice: many coincide, and some end where they begin. None
/// is a short cut.
TaskSet lattice_tasks(Dice& dice, std::uint32_t count, const Transit& transit) {
  const auto point = [&] {
    return Vec3(double(dice.below(5)), double(dice.below(5)), double(dice.below(2)));
  };
  TaskSet set;
  for (std::uint32_t j = 0; j < count; ++j) {
    const Vec3 first = point(), last = point();
    const double length = std::max(transit.length_m(first, last), transit.length_m(last, first)) +
                          1 + static_cast<double>(dice.below(4));
    set.tasks.push_back({{j}, {j}, 0, length, first, last, 1 + dice.unit()});
  }
  return set;
}

bool appends(ScoreKind kind) {
  return kind == ScoreKind::independent || kind == ScoreKind::discounted_append;
}
bool rewards(ScoreKind kind) {
  return kind != ScoreKind::minimax && kind != ScoreKind::minimax_long_first &&
         kind != ScoreKind::minisum;
}
bool diminishes(ScoreKind kind) {
  return kind == ScoreKind::minimax || kind == ScoreKind::minimax_long_first || appends(kind);
}

/// The plain reading of the scores.
struct Naive {
  const TaskSet& set;
  const Uav& uav;
  const Transit& transit;
  const AuctionSettings& settings;

  double metres(const Path& path) const {
    double sum = 0;
    Vec3 at = uav.home_m;
    for (const PathStop& stop : path) {
      const Task& task = set.tasks[stop.task.value];
      sum += transit.length_m(at, stop.reversed ? task.last_m : task.first_m) + task.length_m();
      at = stop.reversed ? task.first_m : task.last_m;
    }
    return set.return_home ? sum + transit.length_m(at, uav.home_m) : sum;
  }

  double reward(const Path& path) const {
    double sum = 0, time = 0;
    Vec3 at = uav.home_m;
    for (const PathStop& stop : path) {
      const Task& task = set.tasks[stop.task.value];
      const Vec3& entry = stop.reversed ? task.last_m : task.first_m;
      time += (transit.length_m(at, entry) + task.length_m()) / uav.speed_mps;
      sum += task.value * std::exp(-settings.discount_per_s * time);
      at = stop.reversed ? task.first_m : task.last_m;
    }
    return sum;
  }

  /// c_ij for one insertion.
  double gain(const Path& path, TaskId task, std::size_t position, bool reversed) const {
    Path longer = path;
    longer.insert(longer.begin() + static_cast<std::ptrdiff_t>(position), {task, reversed});
    if (settings.score == ScoreKind::independent) return reward({{task, reversed}});
    if (rewards(settings.score)) return reward(longer) - reward(path);
    if (settings.score == ScoreKind::minimax) return -metres(longer) / uav.speed_mps;
    if (settings.score == ScoreKind::minimax_long_first)
      return (2 * set.tasks[task.value].length_m() - metres(longer)) / uav.speed_mps;
    return -(metres(longer) - metres(path)) / uav.speed_mps;
  }

  Insertion best(const Path& path, TaskId task) const {
    Insertion best{-HUGE_VAL, 0, false};
    const std::size_t first = appends(settings.score) ? path.size() : 0;
    for (auto l = static_cast<std::uint32_t>(first); l <= path.size(); ++l)
      for (const bool reversed : {false, true})
        if (const double c = gain(path, task, l, reversed); c > best.gain) best = {c, l, reversed};
    return best;
  }
};

struct World {
  World(std::uint64_t seed, ScoreKind kind, std::uint32_t tasks) : dice(seed) {
    set = lattice_tasks(dice, tasks, transit);
    set.return_home = seed % 3 > 0;
    uav = {{1}, Vec3(double(dice.below(5)), double(dice.below(5)), 0), 2.0};
    settings.score = kind;
    score = make_score(set, uav, settings, transit);
  }
  Dice dice;
  TaskSet set;
  Uav uav;
  AuctionSettings settings;
  LatticeTransit transit;
  std::unique_ptr<PathScore> score;
  Naive naive{set, uav, transit, settings};
};

std::vector<TaskId> all_tasks(const TaskSet& set) {
  std::vector<TaskId> tasks;
  for (const Task& task : set.tasks) tasks.push_back(task.id);
  return tasks;
}

class Score : public ::testing::TestWithParam<ScoreKind> {
 protected:
  /// Inserts, asks, retires and re-assigns at random; `compare` sees every answer.
  template <class Compare>
  void random_walk(World& world, int steps, Compare compare) {
    Dice& dice = world.dice;
    Path path;
    std::vector<TaskId> open = all_tasks(world.set);
    for (int step = 0; step < steps && !open.empty(); ++step) {
      for (const TaskId task : open) {
        const auto [bound, exact] = world.score->bound(task);
        if (dice.unit() < 0.4) continue;
        const Insertion where = world.score->best(task);
        compare(where, path, task);
        EXPECT_GE(bound, where.gain);
        EXPECT_TRUE(!exact || bound == where.gain);
      }
      const std::size_t at = dice.below(open.size());
      const TaskId task = open[at];
      if (const double what = dice.unit(); what < 0.7) {
        const Insertion where = world.score->best(task);
        world.score->insert(task, where);
        path.insert(path.begin() + where.position, {task, where.reversed});
        open.erase(open.begin() + static_cast<std::ptrdiff_t>(at));
      } else if (what < 0.85) {
        world.score->retire(task);
        open.erase(open.begin() + static_cast<std::ptrdiff_t>(at));
      } else {
        std::erase_if(path, [&](const PathStop&) { return dice.unit() < 0.4; });
        world.score->assign(path);
        open = all_tasks(world.set);
        for (const PathStop& stop : path) std::erase(open, stop.task);
      }
      ASSERT_EQ(world.score->path(), path);
    }
  }
};

std::string name_of(const ::testing::TestParamInfo<ScoreKind>& kind) {
  std::string name(arcbid::name_of(kind.param));
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, Score,
                         ::testing::Values(ScoreKind::minimax, ScoreKind::minisum,
                                           ScoreKind::independent, ScoreKind::discounted_append,
                                           ScoreKind::discounted_insert,
                                           ScoreKind::discounted_insert_warped,
                                           ScoreKind::minimax_long_first),
                         name_of);

TEST_P(Score, EqualsAFullRecomputation) {
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    World world(seed, GetParam(), 14);
    random_walk(world, 40, [&](const Insertion& got, const Path& path, TaskId task) {
      const Insertion expected = world.naive.best(path, task);
      ASSERT_NEAR(got.gain, expected.gain, 1e-9);
      // The place may differ only where exponentials round two true equals apart.
      ASSERT_NEAR(world.naive.gain(path, task, got.position, got.reversed), expected.gain, 1e-9);
      if (rewards(GetParam())) return;
      ASSERT_EQ(got.gain, expected.gain);
      ASSERT_EQ(got.position, expected.position) << "a tie goes to the earlier position";
      ASSERT_EQ(got.reversed, expected.reversed) << "a tie goes to the direction of the arc";
    });
    if (HasFatalFailure()) return;
  }
}

TEST_P(Score, DependsOnThePathAloneAndNotOnHowItCameAbout) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    World world(seed, GetParam(), 10);
    random_walk(world, 8, [](const Insertion&, const Path&, TaskId) {});
    const auto fresh = make_score(world.set, world.uav, world.settings, world.transit);
    fresh->assign(world.score->path());
    world.score->assign(world.score->path());
    for (const TaskId task : all_tasks(world.set)) {
      const auto in_path = [task](const PathStop& stop) { return stop.task == task; };
      if (std::ranges::any_of(fresh->path(), in_path)) continue;
      EXPECT_EQ(fresh->best(task).gain, world.score->best(task).gain);
      EXPECT_EQ(fresh->best(task).position, world.score->best(task).position);
    }
  }
}

TEST_P(Score, DoesNotReverseATaskThatEndsWhereItBegins) {
  World world(1, GetParam(), 2);
  world.set.tasks[0].last_m = world.set.tasks[0].first_m;
  world.score->assign({});
  EXPECT_FALSE(world.score->best({0}).reversed);
}

TEST_P(Score, SaysWhetherItsGainsDiminish) {
  EXPECT_EQ(World(1, GetParam(), 1).score->diminishing(), diminishes(GetParam()));
}

/// By how much a gain may rise when the path grows by one task; <= 0 when gains diminish.
double largest_rise(ScoreKind kind) {
  double largest = -HUGE_VAL;
  StraightTransit straight;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Mission mission = random_mission(seed, 1, 8);
    mission.auction.score = kind;
    const TaskSet set = split(mission.arcs, std::nullopt, 1000);
    const auto score = make_score(set, mission.fleet[0], mission.auction, straight);
    Dice dice(seed);
    std::vector<TaskId> open = all_tasks(set);
    Path path;
    while (open.size() > 1) {
      const TaskId more = open.back();
      open.pop_back();
      Path longer = path;
      longer.insert(longer.begin() + static_cast<std::ptrdiff_t>(dice.below(path.size() + 1)),
                    {more, dice.unit() < 0.5});
      for (const TaskId task : open) {
        score->assign(path);
        const double before = score->best(task).gain;
        score->assign(longer);
        largest = std::max(largest, score->best(task).gain - before);
      }
      path = longer;
    }
  }
  return largest;
}

TEST(Gains, DiminishUnderMiniMax) {
  EXPECT_LT(largest_rise(ScoreKind::minimax), 1e-9);
  EXPECT_LT(largest_rise(ScoreKind::minimax_long_first), 1e-9);
}

TEST(Gains, DiminishWhereTasksAreAddedAtTheEnd) {
  EXPECT_LT(largest_rise(ScoreKind::independent), 1e-9);
  EXPECT_LT(largest_rise(ScoreKind::discounted_append), 1e-9);
}

TEST(Gains, MayRiseUnderMiniSum) {
  EXPECT_GT(largest_rise(ScoreKind::minisum), 0.1);
}

TEST(Gains, MayRiseUnderTheTimeDiscountedReward) {
  EXPECT_GT(largest_rise(ScoreKind::discounted_insert_warped), 0.1);
}

/// Home at the origin at 2 m/s; task 0 from x = 10 to 14, task 1 from x = 20 to 16.
struct Line {
  Line(ScoreKind kind) {
    set.tasks = {{{0}, {0}, 0, 4, Vec3(10, 0, 0), Vec3(14, 0, 0), 4},
                 {{1}, {1}, 0, 4, Vec3(20, 0, 0), Vec3(16, 0, 0), 4}};
    settings.score = kind;
    score = make_score(set, uav, settings, transit);
    score->insert({0}, score->best({0}));
  }
  TaskSet set;
  Uav uav{{1}, Vec3::Zero(), 2.0};
  AuctionSettings settings;
  StraightTransit transit;
  std::unique_ptr<PathScore> score;
};

TEST(MiniMax, IsMinusTheTimeOfTheClosedTour) {
  Line line(ScoreKind::minimax);
  const Insertion where = line.score->best({1});
  EXPECT_DOUBLE_EQ(where.gain, -20.0);  // out to 20 and back at 2 m/s
  EXPECT_EQ(where.position, 1u);
  EXPECT_FALSE(where.reversed);  // either way is as good
}

TEST(MiniSum, IsMinusTheTimeAdded) {
  Line line(ScoreKind::minisum);
  EXPECT_DOUBLE_EQ(line.score->best({1}).gain, -6.0);
}

TEST(MiniMax, IsMinusTheTimeOfTheOpenPathWhereNobodyReturns) {
  Line line(ScoreKind::minimax);
  line.set.return_home = false;
  line.score->assign({{{0}, false}});
  const Insertion where = line.score->best({1});
  EXPECT_DOUBLE_EQ(where.gain, -10.0);  // out to 20, without the way back
  EXPECT_TRUE(where.reversed);
}

TEST(Independent, AsksOnlyForTheWayFromHome) {
  Line line(ScoreKind::independent);
  const Insertion where = line.score->best({1});
  EXPECT_EQ(where.position, 1u);
  EXPECT_TRUE(where.reversed);
  EXPECT_DOUBLE_EQ(where.gain, 4 * std::exp(-0.02 * 10));
}

TEST(DiscountedAppend, ComesAtTheEndThoughAnEarlierPlaceWereBetter) {
  Line line(ScoreKind::discounted_append);
  line.score->assign({{{1}, true}});
  const Insertion where = line.score->best({0});
  EXPECT_EQ(where.position, 1u);
  EXPECT_TRUE(where.reversed);
  EXPECT_DOUBLE_EQ(where.gain, 4 * std::exp(-0.02 * (10 + 3 + 2)));
}

TEST(Discounted, IsTheLengthDiscountedByTheTimeOfCompletion) {
  Line line(ScoreKind::discounted_insert_warped);
  const Insertion where = line.score->best({1});
  EXPECT_EQ(where.position, 1u);
  EXPECT_TRUE(where.reversed);
  EXPECT_DOUBLE_EQ(where.gain, 4 * std::exp(-0.02 * 10));
}

}  // namespace
}  // namespace testing
}  // namespace arcbid
