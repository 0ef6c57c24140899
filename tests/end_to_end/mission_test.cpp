// SPDX-License-Identifier: GPL-3.0-or-later
// The main job, as a user starts it: real processes, real DDS.
#include <gtest/gtest.h>
#include <set>

#include "core/io/run/agent_log.hpp"
#include "core/io/run/run_log_reader.hpp"
#include "tests/end_to_end/launched.hpp"

namespace arcbid::testing {
namespace {

TEST(Mission, DemoIsAllocatedProvenFlownAndChecked) {
  const Scratch scratch;
  const auto before = shared_memory();
  Launched run({"run", demo_config(), "--out", (scratch / "run").string()});
  ASSERT_EQ(run.wait_for_end(60), 0) << run.output();

  const auto result = read_json(scratch / "run/result.json");
  expect_checked(result, 4);
  for (const char* number : {"arcs", "tasks", "makespan_s", "total_length_m"})
    EXPECT_GT(result[number].get<double>(), 0) << number;
  EXPECT_GT(result["agreement"]["time_s"].get<double>(), 0);
  EXPECT_GE(result["agreement"]["rounds"].get<int>(), 1);
  for (const char* number : {"count", "time"}) {
    EXPECT_GT(result["uniformity"][number].get<double>(), 0) << number;
    EXPECT_LE(result["uniformity"][number].get<double>(), 1) << number;
  }
  EXPECT_GT(result["cv_time"].get<double>(), 0);
  EXPECT_LT(result["cv_time"].get<double>(), 0.5);
  for (const char* number : {"sent", "received", "bytes"})
    EXPECT_GT(result["messages"][number].get<std::uint64_t>(), 0u) << number;
  EXPECT_TRUE(result["messages"]["dropped"].is_number());

  EXPECT_TRUE(all_gone(processes_of(scratch / "run"), 0)) << "processes were left behind";
  EXPECT_EQ(shared_memory(), before) << "shared memory was left behind";
  for (const char* shown : {"makespan", "uniformity E", "agreement", "messages", "checked"})
    EXPECT_NE(run.output().find(shown), std::string::npos) << shown;
}

TEST(Mission, EveryProcessLeavesALogOfWhatItReceivedDecidedAndSent) {
  const Scratch scratch;
  Launched run({"run", demo_config(), "--agents", "2", "--out", (scratch / "run").string()});
  ASSERT_EQ(run.wait_for_end(60), 0) << run.output();
  int agents = 0;
  for (const auto& entry : std::filesystem::directory_iterator(scratch / "run/logs")) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with("agent_") || entry.path().extension() != ".sqlite") continue;
    ++agents;
    const RunLogReader log(entry.path());
    for (const auto kind : {log_kind::mission, log_kind::birth, log_kind::route, log_kind::end})
      EXPECT_TRUE(log.first(kind).has_value()) << name << ": " << kind;
    std::set<std::size_t> heard;
    bool decided = false, stated = false, reported = false, agreed = false;
    log.read(
        [&](const RunLogReader::Record& record) {
          const Step step = decode<Step>(record.body);
          heard.insert(step.event.what.index());
          decided = decided || step.update.decision;
          stated = stated || !step.update.bids.empty();
          reported = reported || !step.update.statuses.empty();
          agreed = agreed || step.update.agreed;
          return true;
        },
        0, log_kind::step);
    EXPECT_TRUE(heard.contains(0) && heard.contains(1) && heard.contains(3)) << "tick, bid, status";
    EXPECT_TRUE(decided && stated && reported && agreed) << name;
  }
  EXPECT_EQ(agents, 2);
}

TEST(Mission, PublishedCbbaDoesTheSameJob) {
  const Scratch scratch;
  const std::string config = std::string(ARCBID_SOURCE_DIR) + "/configs/cbba.yaml";
  Launched run({"run", config, "--out", (scratch / "run").string()});
  ASSERT_EQ(run.wait_for_end(90), 0) << run.output();
  expect_checked(read_json(scratch / "run/result.json"), 4);
}

TEST(Mission, AgentsMayShareAProcess) {
  const Scratch scratch;
  const auto config =
      scratch.file("shared.yaml", "name: shared\nfleet: {agents: 5, agents_per_process: 2}\n");
  Launched run({"run", config.string(), "--out", (scratch / "run").string()});
  ASSERT_EQ(run.wait_for_end(60), 0) << run.output();
  expect_checked(read_json(scratch / "run/result.json"), 5);
  std::set<std::string> names;
  for (const auto& [name, pid] : processes_of(scratch / "run")) names.insert(name);
  EXPECT_EQ(names, (std::set<std::string>{"coordinator", "agents 1,2", "agents 3,4", "agent 5"}));
}

TEST(Mission, NoFaultIsDoneToAProcessThatAgentsShare) {
  const Scratch scratch;
  const auto config =
      scratch.file("shared.yaml", "name: shared\nfleet: {agents: 4, agents_per_process: 2}\n");
  Launched killed(
      {"run", config.string(), "--faults", "crash", "--out", (scratch / "run").string()});
  EXPECT_EQ(killed.wait_for_end(30), 2) << killed.output();
  Launched packets({"run", config.string(), "--faults", "lossy_10", "--fault-tier", "packets",
                    "--out", (scratch / "run").string()});
  EXPECT_EQ(packets.wait_for_end(30), 2) << packets.output();
}

TEST(Mission, OneAgentNeedsNobody) {
  const Scratch scratch;
  Launched run({"run", demo_config(), "--agents", "1", "--out", (scratch / "run").string()});
  ASSERT_EQ(run.wait_for_end(60), 0) << run.output();
  expect_checked(read_json(scratch / "run/result.json"), 1);
}

TEST(Mission, TwoRunsAtOnceDoNotMeet) {
  const Scratch scratch;
  Launched first({"run", demo_config(), "--agents", "3", "--out", (scratch / "first").string()});
  Launched second({"run", demo_config(), "--agents", "2", "--out", (scratch / "second").string()});
  ASSERT_EQ(first.wait_for_end(90), 0) << first.output();
  ASSERT_EQ(second.wait_for_end(90), 0) << second.output();
  expect_checked(read_json(scratch / "first/result.json"), 3);
  expect_checked(read_json(scratch / "second/result.json"), 2);
  for (const char* run : {"first", "second"})
    EXPECT_EQ(read_json(scratch / (std::string(run) + "/result.json"))["messages"]["dropped"], 0)
        << run;
}

TEST(Mission, TheCheckerCanBeRunAgainAndSeesDamage) {
  const Scratch scratch;
  Launched run({"run", demo_config(), "--agents", "2", "--out", (scratch / "run").string()});
  ASSERT_EQ(run.wait_for_end(60), 0) << run.output();
  EXPECT_EQ(Launched({"check", (scratch / "run").string()}).wait_for_end(20), 0);
  std::filesystem::remove(scratch / "run/routes/agent_2.json");
  EXPECT_EQ(Launched({"check", (scratch / "run").string()}).wait_for_end(20), 1);
}

}  // namespace
}  // namespace arcbid::testing
