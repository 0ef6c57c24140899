// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/world/shrink.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "sim/world/settings_file.hpp"

namespace arcbid::testing {
namespace {

WorldSettings mixed() {
  return load_worlds(std::string(ARCBID_SOURCE_DIR) + "/configs/sim.yaml");
}

/// A world of many parts.
WorldSpec rich_world() {
  const WorldSettings settings = mixed();
  for (std::uint64_t seed = 1;; ++seed) {
    WorldSpec spec = make_world(settings, seed);
    const WorldSize size = size_of(spec);
    if (size.faults >= 6 && size.agents >= 5 && size.arcs >= 6) return spec;
  }
}

TEST(Shrink, LeavesOnlyWhatTheFailureNeeds) {
  const WorldSpec spec = rich_world();
  const AgentId needed = spec.mission.fleet[2].id;
  const auto fails = [&](const WorldSpec& world) {
    const auto& fleet = world.mission.fleet;
    const bool agent =
        std::any_of(fleet.begin(), fleet.end(), [&](const Uav& uav) { return uav.id == needed; });
    return agent && world.faults.links.size() + world.faults.agents.size() >= 2;
  };
  ASSERT_TRUE(fails(spec));
  const WorldSpec small = shrink(spec, fails);
  EXPECT_EQ(size_of(small), (WorldSize{2, 1, 1}));
  EXPECT_EQ(small.mission.fleet[0].id, needed);
  EXPECT_EQ(small.mission.arcs[0].id, ArcId{0});
  for (const WorldSpec& smaller : smaller_worlds(small)) EXPECT_FALSE(fails(smaller));
}

/// ACBBA does not survive mixed faults; what is left of such a world is small, and claims survive
/// it.
TEST(Shrink, FindsWhatAcbbaDoesNotSurvive) {
  WorldSettings settings = mixed();
  settings.policies = {PolicyKind::acbba};
  const auto fails = [](const WorldSpec& world) { return !run_world(world).agreed; };
  WorldSpec small = shrink(make_world(settings, 13), fails);
  ASSERT_TRUE(fails(small));
  EXPECT_EQ(size_of(small).faults, 1u);
  EXPECT_EQ(size_of(small).agents, 3u);
  for (const PolicyKind policy : {PolicyKind::claims, PolicyKind::claims_keep, PolicyKind::cbba}) {
    small.mission.auction.policy = policy;
    EXPECT_FALSE(fails(small)) << name_of(policy);
  }
}

/// The smallest counterexample to bids that are not warped, found by the simulator and shrunk: it
/// needs no fault at all.
TEST(Shrink, FindsThatUnwarpedBidsCycleWithoutAnyFault) {
  WorldSettings settings = mixed();
  settings.scores = {ScoreKind::discounted_insert};
  settings.layouts = {Layout::grid};
  settings.topologies = {TopologyKind::complete};
  settings.agents = {2, 5};
  settings.tasks = {2, 16};
  settings.odds[static_cast<std::size_t>(WorldFault::loss)] = 1;
  const auto fails = [](const WorldSpec& world) { return !run_world(world).agreed; };
  std::optional<WorldSpec> failing;
  for (std::uint64_t seed = 1; seed <= 3000 && !failing; ++seed)
    if (WorldSpec spec = make_world(settings, seed); fails(spec)) failing = std::move(spec);
  ASSERT_TRUE(failing);
  const WorldSpec small = shrink(*failing, fails);
  EXPECT_TRUE(fails(small));
  EXPECT_EQ(size_of(small).faults, 0u);
  EXPECT_LE(size_of(small).agents, 3u);
}

}  // namespace
}  // namespace arcbid::testing
