// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/arcs/mission.hpp"

#include <gtest/gtest.h>

#include <set>

namespace arcbid {
namespace {

TEST(MissionDigest, EveryFieldCounts) {
  Mission mission;
  mission.id = 1;
  mission.name = std::string("mission");
  mission.arcs = {{ArcId{0},
                   ArcKind::outline,
                   {{Vec3(0, 0, 0), Vec3(1, 0, 0)}, {Vec3(1, 0, 0), Vec3(1, 0, 0)}}}};
  mission.fleet = {{AgentId{1}, Vec3(0, 0, 0), 1}, {AgentId{2}, Vec3(0, 3, 0), 1}};
  mission.airspace = {
      Vec3(0, 0, 3), 0.5, {4, 3, 2}, {20, 4}, {{ArcId{0}, 1, {AccessPoint{Vec3(1, 0, 0)}}}}};
  std::set<std::uint64_t> digests = {digest(mission)};
  EXPECT_EQ(digest(Mission(mission)), *digests.begin());
  std::size_t changes = 0;
  const auto change = [&](auto edit) {
    Mission changed = mission;
    edit(changed);
    digests.insert(digest(changed));
    ++changes;
  };
  change([](Mission& m) { m.id = 2; });
  change([](Mission& m) { m.name.push_back('n'); });
  change([](Mission& m) { m.arcs[0].waypoints[1].position_m.x() = 2; });
  change([](Mission& m) { m.fleet.pop_back(); });
  change([](Mission& m) { m.fleet[1].id.value = 3; });
  change([](Mission& m) { m.fleet[1].home_m.z() = 1; });
  change([](Mission& m) { m.fleet[0].speed_mps = 2; });
  change([](Mission& m) { m.airspace = {}; });
  change([](Mission& m) { m.airspace.low_m.z() = 2; });
  change([](Mission& m) { m.airspace.cell_m = 1; });
  change([](Mission& m) { m.airspace.cells = {3, 4, 2}; });
  change([](Mission& m) { m.airspace.runs = {4, 20}; });
  change([](Mission& m) { m.airspace.accesses.clear(); });
  change([](Mission& m) { m.airspace.accesses[0].arc.value = 1; });
  change([](Mission& m) { m.airspace.accesses[0].waypoint = 0; });
  change([](Mission& m) { m.airspace.accesses[0].points[0].position_m.y() = 1; });
  change([](Mission& m) { m.auction.policy = PolicyKind::cbba; });
  change([](Mission& m) { m.auction.score = ScoreKind::minisum; });
  change([](Mission& m) { m.auction.discount_per_s = 1; });
  change([](Mission& m) { m.auction.split_m = 0; });
  change([](Mission& m) { m.auction.split_m = 5; });
  change([](Mission& m) { m.auction.max_tasks = 5; });
  change([](Mission& m) { m.auction.bundle_limit = 5; });
  change([](Mission& m) { m.auction.audit_bids = false; });
  change([](Mission& m) { m.auction.tick_ns = 5; });
  change([](Mission& m) { m.auction.lease_ns = 5; });
  change([](Mission& m) { m.auction.barrier_ns = 5; });
  change([](Mission& m) { m.tour.seed = 5; });
  change([](Mission& m) { m.tour.epochs = 5; });
  change([](Mission& m) { m.tour.iterations = 5; });
  change([](Mission& m) { m.tour.solver = TourSolver::crsom; });
  EXPECT_EQ(digests.size(), 1 + changes);
}

}  // namespace
}  // namespace arcbid
