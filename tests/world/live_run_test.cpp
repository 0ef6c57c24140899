// SPDX-License-Identifier: GPL-3.0-or-later
// Run directories as live runs leave them behind, written by hand.
#include "sim/world/live_run.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <fstream>

#include "core/base/error.hpp"
#include "core/io/run/agent_log.hpp"
#include "core/io/run/arcs_json.hpp"
#include "core/io/run/run_files.hpp"
#include "core/io/run/run_log.hpp"
#include "sim/world/run.hpp"
#include "tests/record/other_build.hpp"

namespace arcbid::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

constexpr TimeNs second = 1'000'000'000;

Mission mission_of_seed(std::uint64_t seed) {
  WorldSettings settings;
  settings.agents = {2, 2};
  settings.tasks = {6, 6};
  Mission mission = make_world(settings, seed).mission;
  mission.auction.split_m.reset();
  mission.auction.bundle_limit = 6;
  mission.arcs.back().kind = ArcKind::underside_row;
  return mission;
}

class LiveRunTest : public ::testing::Test {
 protected:
  LiveRunTest() : mission(mission_of_seed(3)) {
    std::string name = (std::filesystem::temp_directory_path() / "arcbid-live-XXXXXX").string();
    run = mkdtemp(name.data());
    write_arcs_file(run, mission);
    log(1, mission);
    log(2, mission);
    write("result.json", result.dump());
  }
  ~LiveRunTest() override { std::filesystem::remove_all(run); }

  void log(int agent, const Mission& what) const {
    log(agent, encode(what), cdr_kind<Mission>("mission"));
  }
  void log(int agent, const std::string& what, const RecordKind& kind) const {
    const auto file = run / "logs" / fmt::format("agent_{}.17.sqlite", agent);
    std::filesystem::remove(file);
    RunLog out(file);
    out.meta("schema", RunLog::schema);
    out.meta("process", {{"agent", agent}, {"pid", 100 + agent}});
    out.append(agent * second, out.kind(kind), what);
    out.append(9 * second, "end", {{"by", "coordinator"}});
  }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(run / name) << text;
  }
  std::string problem() const {
    try {
      world_of(read_run(run), 1);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  }

  Mission mission;
  std::filesystem::path run;
  json result = {
      {"processes", {{{"name", "agent 1"}, {"pid", 101}}, {{"name", "agent 2"}, {"pid", 102}}}}};
};

TEST_F(LiveRunTest, GivesTheSameMissionBitForBitAndAgrees) {
  const LiveRun live = read_run(run);
  EXPECT_EQ(digest(live.mission), digest(mission));
  ASSERT_EQ(live.lives.size(), 2u);
  EXPECT_EQ(live.lives[1].agent, AgentId{2});
  EXPECT_EQ(live.lives[1].born_ns, 2 * second);
  EXPECT_EQ(live.lives[1].last_ns, 9 * second);
  EXPECT_EQ(live.lives[1].ended_by, "coordinator");
  const WorldResult one = run_world(world_of(live, 1)), other = run_world(world_of(live, 2));
  EXPECT_TRUE(one.agreed && one.violations.empty());
  EXPECT_TRUE(other.agreed && other.violations.empty());
  EXPECT_NE(one.digest, other.digest) << "the seed says how long messages take";
  EXPECT_EQ(one.makespan_s, other.makespan_s);
}

TEST_F(LiveRunTest, TellsASecondProcessFromASecondLife) {
  result["processes"][1]["name"] = "agent 2, second";
  write("result.json", result.dump());
  const LiveRun live = read_run(run);
  EXPECT_FALSE(live.lives[0].is_twin);
  EXPECT_TRUE(live.lives[1].is_twin);
}

TEST_F(LiveRunTest, ReadsWhatWasDoneAndWhatWasToBeDone) {
  result["faults"] = {
      {{"time_s", 1.5}, {"agent", 2}, {"action", "kill"}, {"fault", "agent 2 is killed"}},
      {{"time_s", 2}, {"agent", 0}, {"action", "kill"}, {"fault", "coordinator is killed"}}};
  write("result.json", result.dump());
  write("faults.yaml", "links: [{loss: 0.25}]");
  const LiveRun live = read_run(run);
  ASSERT_EQ(live.acts.size(), 1u) << "a world has no coordinator";
  EXPECT_EQ(live.acts[0].at_ns, 3 * second / 2);
  EXPECT_EQ(live.acts[0].action, "kill");
  ASSERT_EQ(live.schedule.links.size(), 1u);
  EXPECT_EQ(live.schedule.links[0].loss, 0.25);
}

TEST_F(LiveRunTest, LeavesOutALifeThatNeverHadTheMissionAndSaysSo) {
  {
    RunLog log(run / "logs/agent_1.18.sqlite");
    log.meta("schema", RunLog::schema);
    log.meta("process", {{"agent", 1}, {"pid", 103}});
  }
  const LiveRun live = read_run(run);
  EXPECT_EQ(live.lives.size(), 2u);
  EXPECT_THAT(live.left_out, ::testing::ElementsAre(HasSubstr("agent_1.18.sqlite")));
}

TEST_F(LiveRunTest, IsNotMadeOfAMissionThatAnotherArcbidLaidOut) {
  const std::string schema = with(schema_of<Mission>(), "AuctionSettings", "bool audit_bids", "");
  log(1, OtherBuild::encode(mission, StoredSchema(schema)), {"mission", "cdr", schema});
  EXPECT_THAT(problem(), HasSubstr("agent_1.17.sqlite: plays, but cannot be verified: "));
  EXPECT_THAT(problem(), HasSubstr("mission: AuctionSettings.audit_bids is not there"));
}

TEST_F(LiveRunTest, IsNotMadeOfAMissionWhoseSchemaCannotBeRead) {
  log(2, encode(mission), {"mission", "cdr", "strong name\n" + schema_of<Mission>()});
  EXPECT_THAT(problem(), HasSubstr("agent_2.17.sqlite: written by arcbid "));
  EXPECT_THAT(problem(), HasSubstr("mission: its schema cannot be read: its line \"strong\""));
}

TEST_F(LiveRunTest, IsNotMadeOfAMissionThatIsNone) {
  Mission damaged = mission;
  damaged.fleet[1].id = damaged.fleet[0].id;
  log(1, damaged);
  EXPECT_THAT(problem(), HasSubstr("agent_1.17.sqlite: mission: agent 2 of its fleet is none"));
}

TEST_F(LiveRunTest, SaysInOneLineWhatIsMissing) {
  std::filesystem::remove(run / "result.json");
  EXPECT_EQ(problem(), (run / "result.json").string() + ": missing, or not readable");
  write("result.json", result.dump());
  std::filesystem::remove(run / "arcs.json");
  EXPECT_THAT(problem(), HasSubstr("arcs.json: missing"));
  std::filesystem::remove_all(run / "logs");
  EXPECT_THAT(problem(), HasSubstr("logs: No such file or directory"));
  std::filesystem::create_directory(run / "logs");
  EXPECT_THAT(problem(), HasSubstr("logs: no agent's log has the mission"));
}

TEST_F(LiveRunTest, SaysInOneLineWhatIsDamaged) {
  write("result.json", "{\"processes\": [");
  EXPECT_THAT(problem(), HasSubstr("result.json: is not JSON"));
  write("result.json", R"({"processes": [], "faults": [{"time_s": 1, "agent": 1}]})");
  EXPECT_THAT(problem(), HasSubstr("result.json: faults[0].action: missing"));
  write("result.json", R"({"processes": [], "faults": []})");
  EXPECT_THAT(problem(), HasSubstr("faults.yaml"));
  write("result.json", result.dump());
  write("logs/agent_2.17.sqlite", "not a database at all, whatever its name may say of it");
  EXPECT_THAT(problem(), HasSubstr("agent_2.17.sqlite: is not a readable event log"));
}

TEST_F(LiveRunTest, TakesNoMissionThatIsNotTheOneThatWasFlown) {
  Mission other = mission;
  other.fleet[0].speed_mps = 7.5;
  log(2, other);
  EXPECT_THAT(problem(), HasSubstr("but the other logs have " + hex(digest(mission))));
  other = mission;
  other.auction.policy = static_cast<PolicyKind>(77);
  log(2, other);
  EXPECT_THAT(problem(), HasSubstr("mission: field policy: 77, legal: 0 to 4"));
  log(2, mission);
  write_arcs_file(run, mission_of_seed(4));
  EXPECT_THAT(problem(), HasSubstr("arcs.json: mission.id: "));
}

}  // namespace
}  // namespace arcbid::testing
