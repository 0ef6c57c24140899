// SPDX-License-Identifier: GPL-3.0-or-later
// Processes that die, at any time, and how the rest goes on.
#include <gtest/gtest.h>

#include <csignal>
#include <thread>

#include "tests/end_to_end/launched.hpp"

namespace arcbid::testing {
namespace {

/// Rounds go as fast as the network: one that takes its time leaves an auction to die in.
std::filesystem::path slow_network(const Scratch& scratch) {
  return scratch.file("delays.yaml", "links: [{delay: {kind: fixed, least_ms: 120}}]\n");
}

/// Many tasks.
std::filesystem::path slow_config(const Scratch& scratch) {
  return scratch.file("slow.yaml",
                      "name: slow\n"
                      "fleet: {agents: 4}\n"
                      "auction: {split_m: 5, tick_ms: 400, lease_ms: 1500, barrier_ms: 5000}\n"
                      "timeout_s: 60\n");
}

struct Moment {
  const char* name;
  const char* line;  // of the launcher's output, after which the blow falls
  int delay_ms;
};

class DeathAt : public ::testing::TestWithParam<Moment> {};

TEST_P(DeathAt, OfAnAgentIsNoticedAndItsWorkIsDoneByTheOthers) {
  const Scratch scratch;
  Launched run({"run", slow_config(scratch).string(), "--faults", slow_network(scratch).string(),
                "--out", (scratch / "run").string()});
  const auto processes = processes_of(scratch / "run");
  ASSERT_TRUE(run.wait_for(GetParam().line, 30)) << run.output();
  std::this_thread::sleep_for(std::chrono::milliseconds(GetParam().delay_ms));
  ASSERT_EQ(kill(processes.at("agent 2"), SIGKILL), 0);
  ASSERT_EQ(run.wait_for_end(60), 0) << run.output();
  const auto result = read_json(scratch / "run/result.json");
  expect_checked(result, 3);
  for (const auto& agent : result["per_agent"]) EXPECT_NE(agent["agent"], 2);
  EXPECT_NE(run.output().find("agent 2 was ended by signal 9"), std::string::npos) << run.output();
  EXPECT_TRUE(all_gone(processes, 0));
}

INSTANTIATE_TEST_SUITE_P(Moments, DeathAt,
                         ::testing::Values(Moment{"before_the_barrier", "mission published", 0},
                                           Moment{"the_first_round", "bidding for", 0},
                                           Moment{"a_later_round", "bidding for", 300}),
                         [](const auto& at) { return at.param.name; });

TEST(CoordinatorDeath, AfterPublishingCostsNothing) {
  const Scratch scratch;
  Launched run({"run", slow_config(scratch).string(), "--out", (scratch / "run").string()});
  const auto processes = processes_of(scratch / "run");
  ASSERT_TRUE(run.wait_for("bidding for", 30)) << run.output();
  ASSERT_EQ(kill(processes.at("coordinator"), SIGKILL), 0);
  ASSERT_EQ(run.wait_for_end(60), 0) << run.output();
  expect_checked(read_json(scratch / "run/result.json"), 4);
  EXPECT_NE(run.output().find("coordinator was ended by signal 9: the mission was published and is "
                              "not lost"),
            std::string::npos)
      << run.output();
  EXPECT_TRUE(all_gone(processes, 0));
}

TEST(CoordinatorDeath, BeforePublishingEndsTheRunAndSaysSo) {
  const Scratch scratch;
  Launched run({"run", slow_config(scratch).string(), "--out", (scratch / "run").string()});
  const auto processes = processes_of(scratch / "run");
  ASSERT_EQ(kill(processes.at("coordinator"), SIGKILL), 0);
  EXPECT_EQ(run.wait_for_end(60), 1) << run.output();
  EXPECT_NE(run.output().find("nothing was begun"), std::string::npos) << run.output();
  EXPECT_TRUE(all_gone(processes, 0));
}

TEST(Death, AfterAgreementLosesNothingThatWasAgreed) {
  const Scratch scratch;
  Launched run({"run", slow_config(scratch).string(), "--out", (scratch / "run").string()});
  const auto processes = processes_of(scratch / "run");
  ASSERT_TRUE(run.wait_for("agreement proven", 30)) << run.output();
  kill(processes.at("agent 2"), SIGKILL);
  ASSERT_EQ(run.wait_for_end(60), 0) << run.output();
  // Either its route was out already and counts, or the others have agreed anew without it.
  const auto result = read_json(scratch / "run/result.json");
  const std::size_t agents = result["agents"];
  EXPECT_GE(agents, 3u);
  expect_checked(result, agents);
}

TEST(Death, OfAllAgentsEndsTheRunAtOnce) {
  const Scratch scratch;
  Launched run({"run", slow_config(scratch).string(), "--out", (scratch / "run").string()});
  const auto processes = processes_of(scratch / "run");
  ASSERT_TRUE(run.wait_for("bidding for", 30)) << run.output();
  for (const auto& [name, pid] : processes)
    if (name != "coordinator") kill(pid, SIGKILL);
  EXPECT_EQ(run.wait_for_end(20), 1) << run.output();
  EXPECT_NE(run.output().find("no agent is left"), std::string::npos) << run.output();
}

TEST(Timeout, IsToldOnceAndIsAFailure) {
  const Scratch scratch;
  const auto config =
      scratch.file("short.yaml", "auction: {tick_ms: 400, lease_ms: 2000}\ntimeout_s: 1\n");
  const auto silence = scratch.file("silence.yaml", "links: [{loss: 1}]\n");
  Launched run({"run", config.string(), "--faults", silence.string(), "--out",
                (scratch / "run").string()});
  EXPECT_EQ(run.wait_for_end(40), 1) << run.output();
  EXPECT_NE(run.output().find("given up: not done after 1"), std::string::npos) << run.output();
  EXPECT_EQ(run.output().find("take over"), std::string::npos) << run.output();
}

class Stop : public ::testing::TestWithParam<int> {};

TEST_P(Stop, EndsEverythingCleanly) {
  const Scratch scratch;
  const auto before = shared_memory();
  Launched run({"run", slow_config(scratch).string(), "--out", (scratch / "run").string()});
  const auto processes = processes_of(scratch / "run");
  ASSERT_TRUE(run.wait_for("agents up", 30)) << run.output();
  ASSERT_EQ(kill(run.pid(), GetParam()), 0);
  EXPECT_EQ(run.wait_for_end(30), 1) << run.output();
  EXPECT_TRUE(all_gone(processes, 0));
  EXPECT_EQ(shared_memory(), before);
  const auto result = read_json(scratch / "run/result.json");
  for (const auto& process : result["processes"])
    EXPECT_EQ(process["exit_code"], 0) << process.dump() << ": a signal was not obeyed";
}

INSTANTIATE_TEST_SUITE_P(By, Stop, ::testing::Values(SIGTERM, SIGINT));

TEST(LauncherDeath, TakesItsProcessesAlong) {
  const Scratch scratch;
  std::map<std::string, pid_t> processes;
  {
    Launched run({"run", slow_config(scratch).string(), "--out", (scratch / "run").string()});
    processes = processes_of(scratch / "run");
    ASSERT_TRUE(run.wait_for("agents up", 30)) << run.output();
  }  // kill -9
  EXPECT_TRUE(all_gone(processes, 20));
}

}  // namespace
}  // namespace arcbid::testing
