// SPDX-License-Identifier: GPL-3.0-or-later
// A live run, again in the simulator.
#include <gmock/gmock.h>

#include "core/io/run/arcs_json.hpp"
#include "sim/world/live_run.hpp"
#include "tests/end_to_end/launched.hpp"

namespace arcbid::testing {
namespace {

using ::testing::HasSubstr;

constexpr const char* config =
    "name: again\nfleet: {agents: 4}\ncoverage: {fill: false, trim: false}\n"
    "auction: {split_m: 5, tick_ms: 50, lease_ms: 1200, barrier_ms: 3000}\ntimeout_s: 60\n";

std::string run_live(const Scratch& scratch, const std::string& faults) {
  Launched live({"run", scratch.file("config.yaml", config), "--faults",
                 scratch.file("faults.yaml", faults), "--out", (scratch / "run").string()});
  const auto code = live.wait_for_end(60);
  EXPECT_EQ(code, 0) << live.output();
  return (scratch / "run").string();
}

TEST(LiveWorld, AgreesOnTheSameMissionUnderTheSameFaults) {
  const Scratch scratch;
  const std::string run = run_live(scratch,
                                   "links: [{loss: 0.2}]\n"
                                   "agents: [{agent: 2, crash: {at_s: 4, back_after_s: 0.7}}]\n");
  Launched sim({"sim", "--run", run, "--seeds", "1..5"});
  EXPECT_EQ(sim.wait_for_end(60), 0) << sim.output();
  EXPECT_THAT(sim.output(), HasSubstr("5 worlds, 0 with violations"));
  const LiveRun live = read_run(run);
  EXPECT_THAT(sim.output(), HasSubstr("digest " + hex(digest(live.mission))));
  const FaultSchedule faults = faults_of(live);
  const auto crash =
      std::find_if(faults.agents.begin(), faults.agents.end(),
                   [](const AgentFault& fault) { return fault.kind == AgentFaultKind::crash; });
  ASSERT_NE(crash, faults.agents.end());
  EXPECT_EQ(crash->agent, AgentId{2});
  ASSERT_EQ(live.acts.size(), 2u);
  EXPECT_EQ(crash->at_ns, live.acts[0].at_ns) << "when it was killed, not when it was to be";
  EXPECT_GE(*crash->for_ns, live.acts[1].at_ns - live.acts[0].at_ns);
  Launched trace({"sim", "--run", run, "--seeds", "1", "--trace"});
  EXPECT_EQ(trace.wait_for_end(60), 0);
  EXPECT_THAT(trace.output(), HasSubstr("agent 2 is gone"));
}

TEST(LiveWorld, RefusesARunThatNobodySurvived) {
  const Scratch scratch;
  Launched live({"run", scratch.file("config.yaml", config), "--faults",
                 scratch.file("faults.yaml",
                              "agents: [{agent: 1, crash: {at_s: 4}}, {agent: 2, crash: {at_s: 4}},"
                              " {agent: 3, crash: {at_s: 4}}, {agent: 4, crash: {at_s: 4}}]"),
                 "--out", (scratch / "run").string()});
  ASSERT_TRUE(live.wait_for_end(60)) << live.output();
  Launched sim({"sim", "--run", (scratch / "run").string()});
  EXPECT_EQ(sim.wait_for_end(20), 2);
  EXPECT_THAT(sim.output(), HasSubstr("nobody was alive at the end of this run"));
}

TEST(LiveWorld, SaysWhatIsWrongWithWhatItIsGiven) {
  const Scratch scratch;
  Launched nothing({"sim"});
  EXPECT_EQ(nothing.wait_for_end(20), 2);
  EXPECT_THAT(nothing.output(), HasSubstr("CONFIG or --run RUN"));
  Launched both({"sim", demo_config(), "--run", (scratch / "x").string()});
  EXPECT_EQ(both.wait_for_end(20), 2);
  Launched missing({"shrink", "--run", (scratch / "x").string(), "--seed", "1"});
  EXPECT_EQ(missing.wait_for_end(20), 2);
  EXPECT_THAT(missing.output(), HasSubstr("x/result.json: missing"));
}

}  // namespace
}  // namespace arcbid::testing
