// SPDX-License-Identifier: GPL-3.0-or-later
// Live processes under fault schedules.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <set>

#include "core/io/run/agent_log.hpp"
#include "core/io/run/run_log_reader.hpp"
#include "tests/end_to_end/launched.hpp"

namespace arcbid::testing {
namespace {

struct Flight {
  Scratch scratch;
  nlohmann::json result;
  std::string output;
};

/// Runs the demo under `faults` (YAML, or a preset's name) until its good end.
void run_under(const std::string& faults, Flight& run, const std::string& config = "",
               const std::string& tier = "messages") {
  const bool preset = faults.find(':') == std::string::npos;
  const std::string source = preset ? faults : run.scratch.file("faults.yaml", faults).string();
  Launched launched({"run", config.empty() ? demo_config() : config, "--faults", source,
                     "--fault-tier", tier, "--out", (run.scratch / "run").string()});
  const auto code = launched.wait_for_end(60);
  run.output = launched.output();
  ASSERT_EQ(code, 0) << run.output;
  run.result = read_json(run.scratch / "run/result.json");
}

std::string many_rounds(const Scratch& scratch) {
  return scratch
      .file("slow.yaml",
            "name: slow\nfleet: {agents: 4}\n"
            "auction: {split_m: 5, tick_ms: 50, lease_ms: 1200, barrier_ms: 3000}\ntimeout_s: 60\n")
      .string();
}

bool says(const Flight& run, const std::string& text) {
  return run.output.find(text) != std::string::npos;
}

TEST(LinkFaults, LoseWhatTheScheduleSaysAndAreCountedByLink) {
  Flight run;
  run_under("lossy_30", run);
  expect_checked(run.result, 4);
  ASSERT_EQ(run.result["links"].size(), 12u);
  std::uint64_t sent = 0, dropped = 0;
  for (const auto& link : run.result["links"]) {
    EXPECT_GT(link["sent"], 0) << link;
    sent += link["sent"].get<std::uint64_t>();
    dropped += link["dropped"].get<std::uint64_t>();
  }
  const double share = static_cast<double>(dropped) / static_cast<double>(sent);
  EXPECT_GT(share, 0.15);  // a few hundred messages at 0.3
  EXPECT_LT(share, 0.45);
  EXPECT_TRUE(says(run, "dropped by faults")) << run.output;
}

TEST(LinkFaults, LosePacketsUnderDds) {
  Flight run;
  run_under("lossy_30", run, "", "packets");
  expect_checked(run.result, 4);
  EXPECT_EQ(run.result["fault_tier"], "packets");
  ASSERT_EQ(run.result["links"].size(), 12u);
  std::uint64_t sent = 0, dropped = 0;
  for (const auto& link : run.result["links"]) {
    sent += link["sent"].get<std::uint64_t>();
    dropped += link["dropped"].get<std::uint64_t>();
  }
  EXPECT_GT(dropped, 0u);
  EXPECT_LT(dropped, sent / 2);
  EXPECT_TRUE(says(run, "packets sent")) << run.output;
}

TEST(LinkFaults, LeaveAllElseAlone) {
  Flight run;
  run_under("links: [{from: 1, to: 2, cut: true}]", run);
  expect_checked(run.result, 4);
  for (const auto& link : run.result["links"]) {
    const bool cut = link["from"] == 1 && link["to"] == 2;
    EXPECT_EQ(link["dropped"], cut ? link["sent"] : nlohmann::json(0)) << link;
  }
}

TEST(ProcessFaults, AnAgentThatIsKilledComesBackAndTakesPart) {
  Flight run;
  run_under("agents: [{agent: 2, crash: {at_s: 0.8, back_after_s: 0.7}}]", run,
            many_rounds(run.scratch));
  expect_checked(run.result, 4);
  EXPECT_TRUE(says(run, "fault: agent 2 is killed")) << run.output;
  EXPECT_TRUE(says(run, "fault: agent 2 is started")) << run.output;
  ASSERT_EQ(run.result["faults"].size(), 2u);
  EXPECT_GE(run.result["faults"][0]["time_s"], 0.8);
}

TEST(ProcessFaults, AnAgentThatStaysDeadOwnsNothingAndItsReleaseIsSaid) {
  Flight run;
  run_under("agents: [{agent: 3, crash: {at_s: 1}}]", run, many_rounds(run.scratch));
  expect_checked(run.result, 3);
  for (const auto& agent : run.result["per_agent"]) EXPECT_NE(agent["agent"], 3);
  EXPECT_TRUE(says(run, "agent 3 counts as dead")) << run.output;
}

TEST(ProcessFaults, AnAgentThatPausesWithinItsLeaseStaysOfTheFleet) {
  Flight run;
  run_under("agents: [{agent: 1, pause: {at_s: 0.6, for_s: 0.5}}]", run, many_rounds(run.scratch));
  expect_checked(run.result, 4);
  EXPECT_FALSE(says(run, "agent 1 counts as dead")) << run.output;
}

TEST(ProcessFaults, AnAgentMayComeLate) {
  Flight run;
  run_under("agents: [{agent: 4, late: {by_s: 1}}]", run, many_rounds(run.scratch));
  expect_checked(run.result, 4);
}

/// The mission is there when the second one comes: plain arcs take no time to plan. Of two that
/// wait for it together the elder cannot be told for sure.
TEST(ProcessFaults, ASecondProcessWithAnIdIsSentAwayAndTheFirstGoesOn) {
  Flight run;
  const auto plain = run.scratch.file(
      "plain.yaml",
      "name: plain\nfleet: {agents: 4}\ncoverage: {fill: false, trim: false}\n"
      "auction: {split_m: 5, tick_ms: 50, lease_ms: 1200, barrier_ms: 3000}\ntimeout_s: 60\n");
  run_under("agents: [{agent: 2, twin: {at_s: 1.5, for_s: 4}}]", run, plain.string());
  expect_checked(run.result, 4);
  EXPECT_TRUE(says(run, "agent 2, second, ended with exit code 2")) << run.output;
}

TEST(ProcessFaults, TheCoordinatorComesBackWithTheSameMission) {
  Flight run;
  run_under("agents: [{agent: coordinator, crash: {at_s: 0.9, back_after_s: 0.4}}]", run,
            many_rounds(run.scratch));
  expect_checked(run.result, 4);
  EXPECT_TRUE(says(run, "fault: coordinator is started")) << run.output;
  EXPECT_FALSE(says(run, "was refused")) << run.output;
}

/// The agents' logs of a run whose names begin with `prefix`, each with its file's name.
std::vector<std::pair<std::string, RunLogReader>> logs(const std::filesystem::path& run,
                                                       const std::string& prefix) {
  std::vector<std::pair<std::string, RunLogReader>> out;
  for (const auto& entry : std::filesystem::directory_iterator(run / "logs")) {
    const std::string name = entry.path().filename();
    if (name.starts_with(prefix) && entry.path().extension() == ".sqlite")
      out.emplace_back(name, RunLogReader(entry.path()));
  }
  return out;
}

std::string named(const std::string& file, std::uint32_t sender, std::uint64_t sequence) {
  return fmt::format("{} {} {}", file.substr(0, file.find('.')), sender, sequence);
}

/// "receiver sender number" of every message that was lost on the way to an agent.
std::set<std::string> lost_messages(const std::filesystem::path& run) {
  std::set<std::string> out;
  for (const auto& [name, log] : logs(run, "agent_"))
    log.read(
        [&, &file = name](const RunLogReader::Record& record) {
          const auto body = nlohmann::json::parse(record.body);
          return out.insert(named(file, body["sender"], body["sequence"])), true;
        },
        0, "lost");
  return out;
}

/// The same of every message that an agent's core was given.
std::set<std::string> heard_messages(const std::filesystem::path& run) {
  std::set<std::string> out;
  for (const auto& [name, log] : logs(run, "agent_"))
    log.read(
        [&, &file = name](const RunLogReader::Record& record) {
          std::visit(
              [&](const auto& what) {
                if constexpr (requires { what.header; })
                  out.insert(named(file, what.header.sender.value, what.header.sequence));
              },
              decode<Step>(record.body).event.what);
          return true;
        },
        0, log_kind::step);
  return out;
}

std::size_t in_both(const std::set<std::string>& a, const std::set<std::string>& b) {
  return static_cast<std::size_t>(
      std::count_if(a.begin(), a.end(), [&](const std::string& one) { return b.contains(one); }));
}

/// The reasons of all refusals in an agent's logs.
std::vector<std::string> refusals(const std::filesystem::path& run, const std::string& agent) {
  std::vector<std::string> out;
  for (const auto& [name, log] : logs(run, agent + "."))
    log.read(
        [&out](const RunLogReader::Record& record) {
          return out.push_back(nlohmann::json::parse(record.body)["reason"]), true;
        },
        0, "refused");
  return out;
}

TEST(MalformedFaults, AreRefusedByEverybodyWithTheirReasonsAndChangeNothing) {
  Flight run;
  run_under("malformed", run);
  expect_checked(run.result, 4);
  for (const std::string agent : {"agent_1", "agent_2", "agent_3"}) {
    SCOPED_TRACE(agent);
    const std::vector<std::string> reasons = refusals(run.scratch / "run", agent);
    for (const char* reason : {"nan is not allowed", "is outside [0, ", "9999 is not of the fleet",
                               "flies mission", "split the arcs differently"})
      EXPECT_THAT(reasons, ::testing::Contains(::testing::HasSubstr(reason)));
  }
  EXPECT_THAT(refusals(run.scratch / "run", "agent_4"), ::testing::IsEmpty());
  EXPECT_GE(run.result["messages"]["dropped"], 15) << "five kinds, three receivers";
}

TEST(MalformedFaults, AnOverBidderEndsAndTheOthersTakeOverItsArcs) {
  Flight run;
  run_under("over_bidder", run, many_rounds(run.scratch));
  expect_checked(run.result, 3);
  EXPECT_TRUE(says(run, "agent 4 bids far above everybody")) << run.output;
  EXPECT_TRUE(says(run, "agent 4 ended with exit code 1: the others take over")) << run.output;
}

TEST(LinkFaults, DropTheSameMessagesInEveryRun) {
  Flight once, again;
  run_under("lossy_30", once);
  run_under("lossy_30", again);
  const auto lost = [](const Flight& run) { return lost_messages(run.scratch / "run"); };
  const auto heard = [](const Flight& run) { return heard_messages(run.scratch / "run"); };
  EXPECT_GT(in_both(lost(once), lost(again)), 5u);
  EXPECT_GT(in_both(heard(once), heard(again)), 20u);
  EXPECT_EQ(in_both(lost(once), heard(again)), 0u);
  EXPECT_EQ(in_both(heard(once), lost(again)), 0u);
}

TEST(FaultOption, NamesATierAndGoesWithFaults) {
  const Scratch scratch;
  const std::string out = (scratch / "run").string();
  Launched unknown(
      {"run", demo_config(), "--faults", "lossy_30", "--fault-tier", "bytes", "--out", out});
  EXPECT_EQ(unknown.wait_for_end(20), 2);
  EXPECT_NE(unknown.output().find("bytes"), std::string::npos) << unknown.output();
  EXPECT_NE(unknown.output().find("messages,packets"), std::string::npos) << unknown.output();
  Launched alone({"run", demo_config(), "--fault-tier", "packets", "--out", out});
  EXPECT_EQ(alone.wait_for_end(20), 2);
  EXPECT_NE(alone.output().find("--faults"), std::string::npos) << alone.output();
}

TEST(FaultOption, SaysWhatIsWrong) {
  const Scratch scratch;
  Launched run({"run", demo_config(), "--faults", "lossy_31", "--out", (scratch / "run").string()});
  EXPECT_EQ(run.wait_for_end(20), 2);
  EXPECT_FALSE(std::filesystem::exists(scratch / "run"));
}

}  // namespace
}  // namespace arcbid::testing
