// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/replay/doctor.hpp"

#include "core/base/error.hpp"
#include "sim/replay/life_log.hpp"
#include "tests/replay/damaged_run.hpp"

namespace arcbid::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class Doctor : public DamagedRun {};

TEST_F(Doctor, SaysThatARunThatEndedWellIsWhole) {
  record();
  const RunReport report = examine(run);
  EXPECT_TRUE(report.whole());
  ASSERT_EQ(report.logs.size(), 3u);
  const LogReport& of_two = report.logs[1];
  EXPECT_EQ(of_two.agent, 2u);
  EXPECT_EQ(of_two.life, 1002u);
  EXPECT_EQ(of_two.records, records.size());
  EXPECT_EQ(of_two.first_seq, 1);
  EXPECT_EQ(of_two.last_seq, last);
  EXPECT_EQ(of_two.last_ns, 12'000'000'000);
  EXPECT_EQ(of_two.ended_by, "coordinator");
  EXPECT_FALSE(of_two.heard_only);
  EXPECT_THAT(describe(report), HasSubstr("3 logs: 3 whole (0 of killed processes), 0 damaged"));
  EXPECT_EQ(to_json(report)["whole"], true);
}

TEST_F(Doctor, NamesWhatAKilledProcessHadSaidButNotCommitted) {
  std::uint64_t sent = 0;
  {
    RecordedRun recorded(run, random_mission(4, 3, 20));
    recorded.watch = [&](AgentId agent, const Step& step) {
      if (agent != AgentId{2}) return;
      for (const auto& bid : step.update.bids) sent = std::max(sent, bid.header.sequence);
      for (const auto& status : step.update.statuses) sent = std::max(sent, status.header.sequence);
    };
    recorded.run_for(40'000'000);
    recorded.kill({2});
    log = recorded.log({2});
    recorded.run_for(300'000'000);
    recorded.end();
  }
  std::uint64_t committed = 0;
  const LifeLog life(log);
  for (const Mark& mark : life.marks())
    if (mark.sent > 0) committed = mark.first_sent + mark.sent - 1;
  ASSERT_GT(sent, committed);
  const LogReport report = report_of(2);
  EXPECT_TRUE(report.whole()) << "no commit was lost";
  EXPECT_FALSE(report.ended_by);
  ASSERT_TRUE(report.heard_only);
  EXPECT_TRUE(report.heard_only->behind_its_end);
  EXPECT_EQ(report.heard_only->messages, sent - committed);
  EXPECT_THAT(report.heard_only->numbers,
              ElementsAre(std::pair<std::uint64_t, std::uint64_t>(committed + 1, sent)));
  EXPECT_LE(report.heard_only->last_ns, 42'000'000);
  EXPECT_THAT(describe(examine(run)),
              HasSubstr("which is what a killed process had not yet committed"));
}

TEST_F(Doctor, MissesALogByWhatOthersHeard) {
  record();
  fs::remove(log);
  const LogReport report = report_of(2);
  EXPECT_FALSE(report.whole());
  EXPECT_THAT(report.not_read, HasSubstr("there is no log of it"));
  ASSERT_TRUE(report.heard_only);
  EXPECT_EQ(report.heard_only->numbers.front().first, 1u);
}

TEST_F(Doctor, MissesALogByTheProcessesThatWereLaunched) {
  record();
  put_bytes(run / "processes.json",
            R"([{"name": "agent 1", "pid": 1}, {"name": "agent 9", "pid": 77}])");
  const LogReport report = report_of(9);
  EXPECT_EQ(report.pid, 77u);
  EXPECT_THAT(report.not_read, HasSubstr("there is no log of it, and nobody heard it"));
  EXPECT_TRUE(examine(run).whole());
  put_bytes(run / "processes.json", R"([{"name": "coordinator", "pid": 5}])");
  EXPECT_THAT(report_of(0).not_read, HasSubstr("there is no log of it"));
  EXPECT_FALSE(examine(run).whole());
}

TEST_F(Doctor, MissesTheSecondLifeOfAnAgentWhoseFirstIsThere) {
  {
    RecordedRun recorded(run, random_mission(4, 3, 20));
    recorded.run_for(1'000'000'000);
    recorded.kill({2});
    recorded.run_for(3'000'000'000);
    recorded.revive({2});
    recorded.run_for(1'000'000'000);
    log = recorded.log({2});
    recorded.end();
  }
  EXPECT_TRUE(examine(run).whole());
  fs::remove(log);
  const RunReport report = examine(run);
  ASSERT_EQ(report.logs.size(), 4u);
  EXPECT_TRUE(report.logs[1].whole());
  EXPECT_EQ(report.logs[2].life, 2002u);
  EXPECT_FALSE(report.logs[2].whole());
}

TEST_F(Doctor, SaysWhyALogIsNotRead) {
  record();
  put_bytes(log, "");
  EXPECT_THAT(report_of(2).not_read, HasSubstr("it is empty"));
  put_bytes(log, std::string(8192, 'x'));
  EXPECT_THAT(report_of(2).not_read, HasSubstr("file is not a database"));
  fs::remove(log);
  put_bytes(log.string() + "-wal", "left over");
  EXPECT_THAT(report_of(2).not_read, HasSubstr("only its write-ahead log"));
  EXPECT_TRUE(report_of(1).whole());
}

TEST_F(Doctor, DoesNotMissWhatWasNeverBegun) {
  record();
  const auto unborn = run / "logs/agent_2.9000.sqlite";
  put_bytes(unborn, "");
  const RunReport report = examine(run);
  EXPECT_TRUE(report.logs[2].never_began);
  EXPECT_THAT(report.logs[2].not_read, HasSubstr("it ended while it was making its log"));
  EXPECT_TRUE(report.whole());
  put_bytes(unborn, std::string(5000, 'x'));  // no log that was being made looks like that
  EXPECT_FALSE(examine(run).whole());
}

TEST_F(Doctor, TakesNoOtherFolderForARun) {
  fs::create_directories(run / "logs");
  EXPECT_THROW(examine(run), InputError);
  EXPECT_THROW(examine(folder / "nothing"), InputError);
  put_bytes(run / "arcs.json", "{}");
  EXPECT_TRUE(examine(run).logs.empty());
}

}  // namespace
}  // namespace arcbid::testing
