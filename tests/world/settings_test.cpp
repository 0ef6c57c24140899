// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <fstream>
#include <set>
#include <sstream>

#include "core/auction/task_set.hpp"
#include "core/base/error.hpp"
#include "core/io/faults/fault_files.hpp"
#include "sim/world/settings_file.hpp"

namespace arcbid::testing {
namespace {

using ::testing::HasSubstr;

std::string problem(const std::string& text) {
  try {
    parse_worlds(text, "w.yaml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(WorldSettings, AreReadFromYaml) {
  const WorldSettings w = parse_worlds(
      "agents: [3, 5]\ntasks: [10, 10]\npolicies: [cbba]\nscores: [minisum, independent]\n"
      "lease_ms: [300, 600]\nuntil_s: 2.5\nodds: {crash: 0.5}\nprice: false\n",
      "w.yaml");
  EXPECT_EQ(w.agents.least, 3u);
  EXPECT_EQ(w.agents.most, 5u);
  EXPECT_EQ(w.policies, std::vector<PolicyKind>{PolicyKind::cbba});
  EXPECT_EQ(w.scores.size(), 2u);
  EXPECT_EQ(w.lease_ns.most, 600'000'000);
  EXPECT_EQ(w.until_ns, 2'500'000'000);
  EXPECT_EQ(w.odds[static_cast<std::size_t>(WorldFault::crash)], 0.5);
  EXPECT_EQ(w.odds[static_cast<std::size_t>(WorldFault::loss)], 0);
  EXPECT_FALSE(w.price);
}

TEST(WorldSettings, SayWhatIsWrongWhere) {
  EXPECT_THAT(problem("agents: 5"), HasSubstr("w.yaml:1:9: agents: is not [least, most]"));
  EXPECT_THAT(problem("agents: [5, 3]"), HasSubstr("5 is above 3"));
  EXPECT_THAT(problem("agents: [0, 3]"), HasSubstr("0 is outside [1, 64]"));
  EXPECT_THAT(problem("policies: [claimz]"), HasSubstr("did you mean claims?"));
  EXPECT_THAT(problem("odds: {crush: 1}"), HasSubstr("did you mean crash?"));
  EXPECT_THAT(problem("odds: {loss: 2}"), HasSubstr("2 is outside [0, 1]"));
  EXPECT_THAT(problem("scores: []"), HasSubstr("must not be empty"));
  EXPECT_THAT(problem("agent: [2, 3]"), HasSubstr("did you mean agents?"));
}

TEST(WorldSettings, HaveAReferenceInTheDocs) {
  std::ifstream file(std::string(ARCBID_SOURCE_DIR) + "/docs/SIMULATOR.md");
  std::ostringstream text;
  text << file.rdbuf();
  EXPECT_THAT(text.str(), HasSubstr(worlds_reference())) << "put this table there:\n"
                                                         << worlds_reference();
}

/// A failing seed becomes a live run's fault file, and a recorded world's.
TEST(WorldMaker, MakesSchedulesThatFaultFilesCanHold) {
  WorldSettings settings = load_worlds(std::string(ARCBID_SOURCE_DIR) + "/configs/sim.yaml");
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const std::string text = to_yaml(make_world(settings, seed).faults);
    EXPECT_NO_THROW(parse_faults(text, "drawn.yaml")) << seed << "\n" << text;
  }
}

TEST(WorldMaker, StaysWithinItsRangesAndUsesThemUp) {
  const WorldSettings settings = load_worlds(std::string(ARCBID_SOURCE_DIR) + "/configs/sim.yaml");
  std::set<std::size_t> sizes;
  std::set<PolicyKind> policies;
  std::set<ScoreKind> scores;
  std::set<AgentFaultKind> faults;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    const WorldSpec spec = make_world(settings, seed);
    EXPECT_GE(spec.mission.fleet.size(), settings.agents.least);
    EXPECT_LE(spec.mission.fleet.size(), settings.agents.most);
    const TaskSet set = split(spec.mission.arcs, spec.mission.auction.split_m, 1000);
    EXPECT_GE(set.tasks.size(), 1u);
    EXPECT_LE(set.tasks.size(), settings.tasks.most);
    sizes.insert(spec.mission.fleet.size());
    policies.insert(spec.mission.auction.policy);
    scores.insert(spec.mission.auction.score);
    for (const AgentFault& fault : spec.faults.agents) faults.insert(fault.kind);
  }
  EXPECT_EQ(sizes.size(), 11u);
  EXPECT_EQ(policies.size(), 2u);
  EXPECT_EQ(scores.size(), 6u);
  EXPECT_EQ(faults.size(), 6u) << "every kind of agent fault";
}

}  // namespace
}  // namespace arcbid::testing
