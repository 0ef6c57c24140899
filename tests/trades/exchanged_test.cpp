// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/route/exchanged.hpp"

#include <gmock/gmock.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include "core/route/route.hpp"

namespace arcbid {
namespace {

using Paths = std::vector<std::vector<PathStop>>;

/// Long and short arcs, cut into pieces that go to anybody, some to nobody.
struct Won {
  explicit Won(std::uint64_t seed) {
    boost::random::mt19937_64 dice(seed);
    const auto within = [&](double most) {
      return boost::random::uniform_real_distribution<double>(0, most)(dice);
    };
    for (std::uint32_t n = 0; n < 2 + seed % 5; ++n) {
      const Vec3 first(within(100), within(100), within(30));
      const Vec3 last = first + Vec3(1 + within(60), within(60), 0);
      mission.arcs.push_back(
          {{n}, ArcKind::outline, {{first, Vec3::UnitX()}, {last, Vec3::UnitX()}}});
    }
    for (std::uint32_t i = 0; i < 1 + seed % 4; ++i)
      mission.fleet.push_back({{i + 1}, Vec3(within(100), within(100), 0), 1 + within(2)});
    mission.auction.trades = TradesKind::cheap;
    set = split(mission.arcs, 5, 1000);
    paths.resize(mission.fleet.size());
    for (const Task& task : set.tasks)
      if (seed % 3 > 0 || dice() % 8 > 0)
        paths[dice() % paths.size()].push_back({task.id, dice() % 2 == 0});
  }
  FleetPaths exchanged() const {
    return arcbid::exchanged(mission, mission.fleet, set, paths, transit);
  }
  Mission mission;
  TaskSet set;
  Paths paths;
  StraightTransit transit;

  double time_s(const Paths& flown, std::size_t i) const {
    Vec3 at = mission.fleet[i].home_m;
    double metres = 0;
    for (const PathStop& stop : flown[i]) {
      const Task& task = set.tasks[stop.task.value];
      metres += (at - (stop.reversed ? task.last_m : task.first_m)).norm() + task.length_m();
      at = stop.reversed ? task.first_m : task.last_m;
    }
    metres += (at - mission.fleet[i].home_m).norm();
    return metres / mission.fleet[i].speed_mps;
  }
  double slowest_s(const Paths& flown) const {
    double slowest_s = 0;
    for (std::size_t i = 0; i < flown.size(); ++i)
      slowest_s = std::max(slowest_s, time_s(flown, i));
    return slowest_s;
  }
};

std::vector<std::size_t> owners(const Paths& paths, std::size_t tasks) {
  std::vector<std::size_t> count(tasks);
  for (const auto& path : paths)
    for (const PathStop& stop : path) ++count.at(stop.task.value);
  return count;
}

TEST(Exchanged, FliesTheSameTasksOnceAndIsNeverSlower) {
  std::size_t better = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Won won(seed);
    const FleetPaths after = won.exchanged();
    EXPECT_EQ(owners(after.paths, won.set.tasks.size()), owners(won.paths, won.set.tasks.size()));
    EXPECT_LE(won.slowest_s(after.paths), won.slowest_s(won.paths) + 1e-9);
    better += won.slowest_s(after.paths) < 0.8 * won.slowest_s(won.paths);
  }
  EXPECT_GT(better, 90u);
}

TEST(Exchanged, OffLeavesWhatWasWon) {
  Won won(2);
  won.mission.auction.trades = TradesKind::off;
  const FleetPaths after = won.exchanged();
  EXPECT_EQ(after.paths, won.paths);
  EXPECT_EQ(after.exchanges, 0u);
}

TEST(Exchanged, EndsSoonWhenItIsNotWantedAnyMore) {
  const Won won(7);
  int asked = 0;
  const FleetPaths after = exchanged(won.mission, won.mission.fleet, won.set, won.paths,
                                     won.transit, [&] { return ++asked < 3; });
  EXPECT_EQ(asked, 3);
  EXPECT_FALSE(after.is_better);
  EXPECT_EQ(after.paths, won.paths);
}

TEST(Exchanged, EveryMemberWorksOutTheSame) {
  const Won won(7);
  EXPECT_EQ(won.exchanged().paths, won.exchanged().paths);
}

/// Homes far apart, arcs that everybody would like to have: limits decide.
TEST(Exchanged, KeepsLimitsOfTheMembers) {
  std::size_t better = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Won won(seed);
    for (Arc& arc : won.mission.arcs)
      arc.payload = arc.id.value % 2 ? Payload::lidar : Payload::any;
    Paths& paths = won.paths;
    Uav& first = won.mission.fleet[0];
    first.payload = Payload::camera;
    // What is won keeps the limits too.
    std::erase_if(paths[0], [&](const PathStop& stop) {
      return won.set.tasks[stop.task.value].arc.value % 2 == 1;
    });
    for (std::size_t i = 0; i < paths.size(); ++i)
      won.mission.fleet[i].endurance_s = 1.02 * won.time_s(paths, i) + 1;
    won.mission.auction.bundle_limit =
        static_cast<std::uint32_t>(std::ranges::max(paths, {}, &Paths::value_type::size).size());
    const FleetPaths after = won.exchanged();
    better += after.is_better;
    for (std::size_t i = 0; i < paths.size(); ++i) {
      EXPECT_LE(won.time_s(after.paths, i), *won.mission.fleet[i].endurance_s + 1e-9);
      EXPECT_LE(after.paths[i].size(), won.mission.auction.bundle_limit);
    }
    for (const PathStop& stop : after.paths[0])
      EXPECT_EQ(won.set.tasks[stop.task.value].arc.value % 2, 0u);
    EXPECT_EQ(owners(after.paths, won.set.tasks.size()), owners(paths, won.set.tasks.size()));
  }
  EXPECT_GT(better, 40u);
}

/// One long arc and two UAVs, one at either end: who won all of it hands half of it over.
TEST(Exchanged, CutsAnArcThatIsLongBesideWhatOneFlies) {
  Mission mission;
  mission.arcs.push_back(
      {{0}, ArcKind::outline, {{Vec3(0, 0, 0), Vec3::UnitX()}, {Vec3(100, 0, 0), Vec3::UnitX()}}});
  mission.fleet = {{{1}, Vec3(0, 1, 0), 1}, {{2}, Vec3(100, 1, 0), 1}};
  const TaskSet set = split(mission.arcs, 5, 1000);
  Paths paths(2);
  for (const Task& task : set.tasks) paths[0].push_back({task.id, false});
  const StraightTransit transit;
  mission.auction.trades = TradesKind::full;
  const FleetPaths after = exchanged(mission, mission.fleet, set, paths, transit);
  for (std::size_t i = 0; i < 2; ++i) {
    const Route route = plan_route(mission, set, after.paths[i], mission.fleet[i], transit);
    EXPECT_LT(route.length_m, 105) << "UAV " << i + 1;
    EXPECT_EQ(route.pieces, 1u) << "UAV " << i + 1;
  }
}

}  // namespace
}  // namespace arcbid
