// SPDX-License-Identifier: GPL-3.0-or-later
// A recorded world, read by all that reads a live run's directory.
#include <gmock/gmock.h>
#include <sqlite3.h>

#include <cmath>
#include <fstream>

#include "core/base/error.hpp"
#include "sim/replay/doctor.hpp"
#include "sim/replay/run_archive.hpp"
#include "sim/replay/what_if.hpp"
#include "sim/world/world_log.hpp"
#include "tests/end_to_end/launched.hpp"

namespace arcbid::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

WorldSettings settings_of(std::initializer_list<WorldFault> faults) {
  WorldSettings settings;
  settings.agents = {4, 5};
  settings.tasks = {8, 15};
  settings.topologies = {TopologyKind::complete, TopologyKind::ring, TopologyKind::geometric};
  settings.until_ns = 1'000'000'000;
  for (const WorldFault fault : faults) settings.odds[static_cast<std::size_t>(fault)] = 1;
  return settings;
}

WorldResult record(const WorldSpec& world, const fs::path& directory) {
  WorldLog log(world, directory);
  WorldResult result = run_world(world, {}, &log);
  log.write_result(result);
  return result;
}

/// A world in which agent 2 dies for good.
WorldSpec world_with_a_death() {
  WorldSpec world = make_world(settings_of({WorldFault::loss}), 4);
  AgentFault crash;
  crash.agent = {2};
  crash.at_ns = 3'000'000'000;
  world.faults.agents.push_back(crash);
  return world;
}

/// The output of a command that has to succeed.
std::string said(const std::vector<std::string>& arguments) {
  Launched command(arguments);
  EXPECT_EQ(command.wait_for_end(60), 0) << command.output();
  return command.output();
}

/// The log of the first life of agent 2.
fs::path log_of_two(const fs::path& run) {
  for (const auto& entry : fs::directory_iterator(run / "logs"))
    if (entry.path().filename().string().starts_with("agent_2.") &&
        entry.path().extension() == ".sqlite")
      return entry.path();
  ADD_FAILURE() << "agent 2 has no log";
  return {};
}

const LogReport& report_of_two(const RunReport& report) {
  for (const LogReport& log : report.logs)
    if (log.agent == 2u) return log;
  throw std::runtime_error("nothing is said of agent 2");
}

void overwrite(const fs::path& file, std::int64_t seq, const std::string& body) {
  sqlite3* db = nullptr;
  ASSERT_EQ(sqlite3_open(file.c_str(), &db), SQLITE_OK);
  sqlite3_stmt* change = nullptr;
  sqlite3_prepare_v2(db, "UPDATE events SET body = ? WHERE seq = ?", -1, &change, nullptr);
  sqlite3_bind_blob(change, 1, body.data(), static_cast<int>(body.size()), SQLITE_TRANSIENT);
  sqlite3_bind_int64(change, 2, seq);
  EXPECT_EQ(sqlite3_step(change), SQLITE_DONE);
  EXPECT_EQ(sqlite3_changes(db), 1);
  sqlite3_finalize(change);
  sqlite3_close(db);
}

/// Flips the last bit of a bid that the agent stated, as a disk might.
void flip_a_bid(const fs::path& file) {
  const LifeLog life(file);
  for (std::size_t mark = 0; mark < life.marks().size(); ++mark) {
    if (!life.marks()[mark].changed) continue;
    Step step = life.step(mark);
    auto* claims = std::get_if<Claims>(&step.update.decision->body);
    if (!claims || claims->bundle.empty()) continue;
    double& bid = claims->bundle.front().bid;
    bid = std::nextafter(bid, 0);
    return overwrite(file, life.marks()[mark].seq, encode(step));
  }
  ADD_FAILURE() << "there is no bid";
}

class RecordedWorld : public ::testing::TestWithParam<std::uint64_t> {
 protected:
  const Scratch scratch;
  const fs::path run = scratch / "run";
};

TEST_P(RecordedWorld, ComesOutAgainBitForBit) {
  const WorldSpec world =
      make_world(settings_of({WorldFault::loss, WorldFault::delay, WorldFault::duplicate,
                              WorldFault::partition, WorldFault::crash_return, WorldFault::pause,
                              WorldFault::clock, WorldFault::twin, WorldFault::late,
                              WorldFault::malformed, WorldFault::over_bid}),
                 GetParam());
  const WorldResult recorded = record(world, run);
  const LiveRun again = read_run(run);
  EXPECT_EQ(again.seed, GetParam());
  const WorldResult baseline = run_world(world_of(again, again.seed));
  EXPECT_EQ(baseline.digest, recorded.digest);
  EXPECT_EQ(baseline.winners, recorded.winners);
  EXPECT_EQ(owners_changed(baseline, recorded), 0u);
  EXPECT_NE(run_world(world_of(again, again.seed + 1)).digest, recorded.digest);
}
INSTANTIATE_TEST_SUITE_P(Seeds, RecordedWorld, ::testing::Range<std::uint64_t>(1, 9));

using ARecordedWorld = RecordedWorld;

TEST_F(ARecordedWorld, IsSimulatedUnderOtherRules) {
  const WorldResult recorded = record(world_with_a_death(), run);
  ASSERT_TRUE(recorded.agreed);
  const std::string without = said({"whatif", run, "--without", "3"});
  EXPECT_THAT(without, HasSubstr("worlds that agreed: 1 and 1 of 1"));
  EXPECT_THAT(without, HasSubstr(fmt::format("{:<22}{:>14.3f}", "makespan s", recorded.makespan_s)))
      << "as it was";
  EXPECT_THAT(said({"sim", "--run", run, "--seeds", "1..3"}),
              HasSubstr("3 worlds, 0 with violations"));
}

TEST_F(ARecordedWorld, IsExplainedWithTheDeadAgentAlive) {
  const WorldResult recorded = record(world_with_a_death(), run);
  std::size_t told = 0;
  for (std::size_t arc = 0; arc < world_with_a_death().mission.arcs.size(); ++arc) {
    const auto json =
        nlohmann::json::parse(said({"explain", run, "--arc", std::to_string(arc), "--json", "-"}));
    for (const auto& task : json["tasks"]) {
      if (!task.contains("with_agent_alive")) continue;
      const auto& alive = task["with_agent_alive"];
      ASSERT_FALSE(alive.contains("problem")) << alive["problem"];
      const Belief& winner = recorded.winners[task["task"].get<std::size_t>()];
      EXPECT_EQ(alive["owner"]["before"], fmt::format("agent {}", winner.winner->value));
      EXPECT_EQ(alive["makespan_s"]["before"], recorded.makespan_s);
      ++told;
    }
  }
  EXPECT_GT(told, 0u);
}

TEST_F(ARecordedWorld, SaysWhatWasDoneToItsProcesses) {
  record(world_with_a_death(), run);
  const nlohmann::json faults = read_json(run / "result.json")["faults"];
  ASSERT_EQ(faults.size(), 1u) << faults;
  EXPECT_EQ(faults[0]["agent"], 2);
  EXPECT_EQ(faults[0]["action"], "kill");
  EXPECT_NEAR(faults[0]["time_s"], 3.0, 1e-9);
  EXPECT_THAT(faults[0]["fault"].get<std::string>(), HasSubstr("agent 2"));
}

TEST_F(ARecordedWorld, IsWholeAndMissesALogThatIsGone) {
  record(world_with_a_death(), run);
  const RunReport whole = examine(run);
  EXPECT_TRUE(whole.whole()) << describe(whole);
  for (const LogReport& log : whole.logs)
    EXPECT_EQ(log.ended_by.has_value(), log.agent != 2u) << log.agent;
  fs::remove(log_of_two(run));
  const RunReport missing = examine(run);
  EXPECT_FALSE(missing.whole());
  EXPECT_EQ(missing.logs.size(), whole.logs.size());
  EXPECT_THAT(report_of_two(missing).not_read, HasSubstr("there is no log of it"));
}

TEST_F(ARecordedWorld, IsDamagedWhereALogWasCut) {
  record(world_with_a_death(), run);
  const fs::path log = log_of_two(run);
  const auto size = fs::file_size(log);
  fs::resize_file(log, size / 2);
  const RunReport cut = examine(run);
  EXPECT_FALSE(report_of_two(cut).whole());
  EXPECT_TRUE(report_of_two(cut).heard_only) << "by what others heard of it";
  EXPECT_EQ(report_of_two(cut).file, log) << "its name is read";
  Launched doctor({"doctor", run});
  EXPECT_EQ(doctor.wait_for_end(60), 1) << doctor.output();
}

TEST_F(ARecordedWorld, IsVerifiedUntilOneBitOfOneBidIsFlipped) {
  record(world_with_a_death(), run);
  EXPECT_THAT(said({"replay", run, "--verify"}), HasSubstr("verified: "));
  flip_a_bid(log_of_two(run));
  Launched verify({"replay", run, "--verify"});
  EXPECT_EQ(verify.wait_for_end(60), 1) << verify.output();
  EXPECT_THAT(verify.output(), HasSubstr("first divergence: agent 2, round "));
  EXPECT_THAT(verify.output(), HasSubstr(".bid"));
}

TEST_F(ARecordedWorld, IsRefusedWhereTheFileThatMadeItIsDamaged) {
  record(world_with_a_death(), run);
  const auto refusal = [this] {
    try {
      return read_run(run), std::string("accepted");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
  };
  nlohmann::json result = read_json(run / "result.json");
  result["world"]["latency_ns"] = {5, 4};
  std::ofstream(run / "result.json") << result;
  EXPECT_THAT(refusal(), HasSubstr("result.json: world.latency_ns"));
  result["world"]["latency_ns"] = {4};
  std::ofstream(run / "result.json") << result;
  EXPECT_THAT(refusal(), HasSubstr("result.json: world.latency_ns"));
  result["world"].erase("seed");
  std::ofstream(run / "result.json") << result;
  EXPECT_THAT(refusal(), HasSubstr("result.json: world.seed: missing"));
}

}  // namespace
}  // namespace arcbid::testing
