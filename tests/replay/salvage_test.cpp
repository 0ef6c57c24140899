// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/replay/salvage.hpp"

#include "core/base/error.hpp"
#include "sim/replay/playback.hpp"
#include "sim/replay/verify.hpp"
#include "tests/replay/damaged_run.hpp"

namespace arcbid::testing {
namespace {

constexpr std::size_t page = 4096;

class Salvage : public DamagedRun {
 protected:
  /// Zeroes the first page from the middle on that costs steps, and salvages the rest.
  LogReport lose_steps() {
    record();
    const std::string whole = bytes_of(log);
    for (std::size_t at = whole.size() / 2 / page * page; at < whole.size(); at += page) {
      std::string damaged = whole;
      damaged.replace(at, page, page, '\0');
      put_bytes(log, damaged);
      const LogReport report = report_of(2);
      if (report.lost.empty() || !report.lost.front().to_seq) continue;
      salvage(run, examine(run), folder / "salvaged");
      return report;
    }
    ADD_FAILURE() << "no page that costs steps";
    return {};
  }
};

TEST_F(Salvage, KeepsEveryIntactRecordUnderItsNumber) {
  const LogReport damaged = lose_steps();
  const auto salvaged = readable(folder / "salvaged/logs" / log.filename(), last);
  for (const std::int64_t seq : intact_by(damaged, last)) {
    ASSERT_TRUE(salvaged.contains(seq)) << seq;
    EXPECT_EQ(salvaged.at(seq), records.at(seq));
  }
  EXPECT_EQ(salvaged.size(), damaged.records);
  const auto reports = examine(folder / "salvaged").logs;
  EXPECT_TRUE(reports[1].complaints.empty()) << "the log itself is sound";
  EXPECT_EQ(reports[1].lost.front().from_seq, damaged.lost.front().from_seq);
  EXPECT_EQ(reports[1].ended_by, "coordinator");
  EXPECT_TRUE(reports[0].whole());
}

TEST_F(Salvage, PlayGoesOnBehindTheGapAndProofStopsAtIt) {
  const LogReport damaged = lose_steps();
  for (const auto& directory : {run, folder / "salvaged"}) {
    const RunArchive archive = open_run(directory);
    const LifeLog& life = archive.lives[1];
    ASSERT_TRUE(life.gap());
    EXPECT_EQ(life.marks()[*life.gap() - 1].seq, damaged.lost.front().from_seq - 1);
    EXPECT_EQ(life.marks()[*life.gap()].seq, *damaged.lost.front().to_seq + 1);
    EXPECT_EQ(life.ended_by(), "coordinator");
    const LifeVerdict verdict = verify(life);
    EXPECT_FALSE(verdict.divergence);
    EXPECT_EQ(verdict.steps, *life.gap());
    EXPECT_EQ(verdict.beyond_proof, life.marks().size() - *life.gap());
    EXPECT_GT(verdict.beyond_proof, 0u);
    const Playback playback(archive);
    std::size_t moments = 0;
    for (const LifeLog& each : archive.lives) moments += each.marks().size();
    EXPECT_EQ(playback.moments().size(), moments);
    EXPECT_TRUE(playback.owners(moments)[0].winner);
  }
}

TEST_F(Salvage, TakesALostMissionFromAnotherLog) {
  record(80);  // it takes pages of its own
  const std::string whole = bytes_of(log), mission = records.at(1).substr(5000, 64);
  std::string damaged = whole;
  const std::size_t at = damaged.find(mission);
  ASSERT_NE(at, std::string::npos);
  damaged.replace(at / page * page, page, page, '\0');
  put_bytes(log, damaged);
  const LogReport report = report_of(2);
  ASSERT_FALSE(report.whole());
  ASSERT_EQ(open_run(run).lives.size(), 2u);
  salvage(run, examine(run), folder / "salvaged");
  const RunArchive archive = open_run(folder / "salvaged");
  ASSERT_EQ(archive.lives.size(), 3u);
  EXPECT_EQ(verify(archive.lives[1]).steps, archive.lives[1].marks().size());
  EXPECT_TRUE(examine(folder / "salvaged").whole());
}

TEST_F(Salvage, ReplacesNothing) {
  record();
  put_bytes(folder / "notes", "mine");
  EXPECT_THROW(salvage(run, examine(run), folder), InputError);
  EXPECT_EQ(bytes_of(folder / "notes"), "mine");
}

TEST_F(Salvage, KeepsOtherFilesAsTheyAre) {
  record();
  put_bytes(run / "result.json", "{}\n");
  std::filesystem::create_directories(run / "routes");
  put_bytes(run / "routes/agent_1.json", "{\"schema\": 1}");
  salvage(run, examine(run), folder / "salvaged");
  EXPECT_EQ(bytes_of(folder / "salvaged/result.json"), "{}\n");
  EXPECT_EQ(bytes_of(folder / "salvaged/routes/agent_1.json"), "{\"schema\": 1}");
}

}  // namespace
}  // namespace arcbid::testing
