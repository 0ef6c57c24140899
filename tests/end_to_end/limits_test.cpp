// SPDX-License-Identifier: GPL-3.0-or-later
// A fleet of which nobody can fly everything, as a user starts it: what is left is told before the
// auction and after it, in every file, and is no success.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/end_to_end/launched.hpp"

namespace arcbid::testing {
namespace {

/// A deck of 60 m; the UAVs stand at its ends, and neither lasts to the other one.
constexpr const char* config = R"(
name: limits
structure:
  parametric: {kind: girder, length_m: 60, width_m: 8, deck_height_m: 10, piers: 1}
coverage: {spacing_m: 5, standoff_m: 4, safety_m: 2}
fleet:
  uavs:
    - {id: 1, home_m: [-40, -20, 0], endurance_s: 150}
    - {id: 2, home_m: [-44, -20, 0], speed_mps: 2, endurance_s: 75, payload: lidar}
    - {id: 3, home_m: [40, -20, 0], payload: camera}
auction: {split_m: 10, tick_ms: 10}
tour: {iterations: 1000}
timeout_s: 60
)";

TEST(Limits, LeaveWhatNobodyCanFlyWithAReasonAndFlyTheRest) {
  const Scratch scratch;
  const std::string out = (scratch / "run").string();
  Launched run({"run", scratch.file("limits.yaml", config).string(), "--out", out});
  ASSERT_EQ(run.wait_for_end(60), 1) << run.output();
  EXPECT_NE(run.output().find("warning: arc "), std::string::npos) << "told before the auction";
  EXPECT_NE(run.output().find("left undone: arc "), std::string::npos) << "and after it";

  const auto result = read_json(scratch / "run/result.json");
  EXPECT_EQ(result["problems"].size(), 0u) << result["problems"];
  EXPECT_TRUE(result["agreement"]["reached"]);
  for (const auto& [name, holds] : result["checks"].items()) EXPECT_TRUE(holds) << name;
  const auto& left = result["no_bidders"];
  ASSERT_GT(left.size(), 0u);
  EXPECT_TRUE(std::ranges::all_of(left, [](const auto& one) {
    return one["why"] == "endurance" || one["why"] == "endurance-left";
  })) << left;
  EXPECT_TRUE(std::ranges::any_of(left, [](const auto& one) { return one["why"] == "endurance"; }));
  EXPECT_GT(result["left_m"].get<double>(), 10);
  EXPECT_GT(result["per_agent"][0]["arcs"].get<int>() + result["per_agent"][1]["arcs"].get<int>(),
            0);
  EXPECT_LE(result["per_agent"][0]["time_s"].get<double>(), 150.001);
  EXPECT_LE(result["per_agent"][1]["time_s"].get<double>(), 75.001);
  EXPECT_EQ(result["per_agent"][2]["arcs"], 0) << "it carries a camera";
  for (const auto& agent : {"agent_1", "agent_2", "agent_3"})
    EXPECT_EQ(read_json(scratch /
                        ("run/routes/" + std::string(agent) + ".json"))["agreement"]["no_bidders"]
                  .size(),
              left.size());

  Launched again({"check", out});
  EXPECT_EQ(again.wait_for_end(30), 1);
  EXPECT_NE(again.output().find("\"ok\": true"), std::string::npos) << again.output();
  Launched replay({"replay", out, "--verify"});
  EXPECT_EQ(replay.wait_for_end(60), 0) << replay.output();
}

TEST(Limits, OfNobodyMakeAPlanThatIsWhole) {
  const Scratch scratch;
  std::string unlimited = config;
  for (const std::string limit :
       {", endurance_s: 150", ", endurance_s: 75", ", payload: lidar", ", payload: camera"})
    unlimited.erase(unlimited.find(limit), limit.size());
  const std::string file = scratch.file("whole.yaml", unlimited).string();
  Launched plan({"plan", "--config", file, "--out", (scratch / "plan").string()});
  EXPECT_EQ(plan.wait_for_end(60), 0) << plan.output();
  EXPECT_EQ(read_json(scratch / "plan/result.json")["no_bidders"].size(), 0u);
  const std::string limited = scratch.file("limits.yaml", config).string();
  Launched less({"plan", "--config", limited, "--out", (scratch / "less").string()});
  EXPECT_EQ(less.wait_for_end(60), 1) << less.output();
  EXPECT_NE(less.output().find("left undone: arc "), std::string::npos);
  EXPECT_EQ(less.output().find("problem:"), std::string::npos) << less.output();
  const auto covered = [&](const std::string& name) {
    return read_json(scratch / (name + "/certificate.json"))["coverage_of_visible"].get<double>();
  };
  EXPECT_LT(covered("less"), covered("plan") - 0.1) << "what is left out is not seen";
}

}  // namespace
}  // namespace arcbid::testing
