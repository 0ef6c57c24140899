// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/checker/valid_run.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

namespace arcbid {
namespace {

TEST(ValidRun, PassesWithBackwardsLegsAndCutsInsideSegments) {
  const RunFolder folder;
  folder.write(valid_run());
  const CheckReport report = check_run(folder.path());
  EXPECT_TRUE(report.ok()) << listed(report);
  EXPECT_THAT(report.problems, testing::IsEmpty());
}

TEST(ValidRun, FiguresAreRecomputed) {
  const RunFolder folder;
  folder.write(valid_run());
  const CheckReport report = check_run(folder.path());
  EXPECT_EQ(report.arcs, 2U);
  EXPECT_EQ(report.tasks, 4U);
  EXPECT_EQ(report.agents, 2U);
  ASSERT_EQ(report.per_agent.size(), 2U);
  EXPECT_EQ(report.per_agent[0].agent, 1U);
  EXPECT_EQ(report.per_agent[0].arcs, 1U);
  EXPECT_EQ(report.per_agent[0].tasks, 2U);
  EXPECT_NEAR(report.per_agent[0].length_m, 40, 1e-9);
  EXPECT_NEAR(report.per_agent[0].time_s, 20, 1e-9);
  EXPECT_EQ(report.per_agent[1].arcs, 2U);
  EXPECT_NEAR(report.makespan_s, 43.401219466856727, 1e-9);
  EXPECT_NEAR(report.total_length_m, 83.401219466856727, 1e-9);
  EXPECT_DOUBLE_EQ(report.uniformity_count, 1.0);
  const double half = (43.401219466856727 - 20) / 2;  // from the mean
  EXPECT_NEAR(report.uniformity_time, 2 / (2 * half * half + 2), 1e-12);
}

TEST(ValidRun, AnAgentThatWonNothingStaysHome) {
  RunDocuments run = valid_run();
  run.arcs["fleet"].push_back({{"agent", 3}, {"home_m", {0, 0, 0}}, {"speed_mps", 1.0}});
  nlohmann::json idle = run.agent_1;
  idle["agent"] = 3;
  idle["route"] = {{"length_m", 0.0}, {"time_s", 0.0}, {"legs", nlohmann::json::array()}};
  const RunFolder folder;
  folder.write(run);
  folder.write_text("routes/agent_3.json", idle.dump());
  const CheckReport report = check_run(folder.path());
  EXPECT_TRUE(report.ok()) << listed(report);
  // Counts 2, 2, 0: mean 4/3, squares 8/3.
  EXPECT_NEAR(report.uniformity_count, 3 / (8.0 / 3 + 3), 1e-12);
}

TEST(ValidRun, AnAgentThatDiedOwningNothingIsNoProblem) {
  RunDocuments run = valid_run();
  run.arcs["fleet"].push_back({{"agent", 3}, {"home_m", {0, 0, 0}}, {"speed_mps", 1.0}});
  const RunFolder folder;
  folder.write(run);
  folder.write_text("routes/agent_3.json.part", "{\"schema\": 1, \"agent\"");
  EXPECT_TRUE(check_run(folder.path()).ok());
}

TEST(ValidRun, ExtraPointsOnTheArcAreFine) {
  RunDocuments run = valid_run();
  auto& waypoints = run.agent_1["route"]["legs"][1]["waypoints"];
  waypoints.insert(waypoints.begin() + 2, nlohmann::json({5, 0.0005, 10, 0, 1, 0}));
  const RunFolder folder;
  folder.write(run);
  const CheckReport report = check_run(folder.path());
  EXPECT_TRUE(report.ok()) << listed(report);
}

/// The text of the k-th fenced JSON block.
std::string json_block(const std::string& markdown, int k) {
  const std::string fence = "```json\n";
  std::size_t begin = 0;
  for (int i = 0; i <= k; ++i) begin = markdown.find(fence, begin) + fence.size();
  return markdown.substr(begin, markdown.find("```", begin) - begin);
}

TEST(ValidRun, TheExampleInTheDocumentationPasses) {
  std::ostringstream markdown;
  markdown << std::ifstream(std::string(ARCBID_SOURCE_DIR) + "/docs/RUN_DIRECTORY.md").rdbuf();
  const RunFolder folder;
  folder.write_text("arcs.json", json_block(markdown.str(), 0));
  folder.write_text("routes/agent_1.json", json_block(markdown.str(), 1));
  const CheckReport report = check_run(folder.path());
  EXPECT_TRUE(report.ok()) << listed(report);
}

TEST(ValidRun, ReportAsJson) {
  const RunFolder folder;
  folder.write(valid_run());
  const nlohmann::json json = nlohmann::json::parse(to_json(check_run(folder.path())));
  EXPECT_TRUE(json["ok"].get<bool>());
  EXPECT_EQ(json["per_agent"].size(), 2U);
  EXPECT_EQ(json["per_agent"][1]["tasks"], 2);
  EXPECT_NEAR(json["makespan_s"].get<double>(), 43.401219466856727, 1e-9);
}

}  // namespace
}  // namespace arcbid
