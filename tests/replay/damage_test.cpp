// SPDX-License-Identifier: GPL-3.0-or-later
// Logs that are cut, zeroed and flipped in many places: nothing crashes, and what is said to be
// intact is what can be read.
#include "agent/recorded_messages.hpp"
#include "core/base/error.hpp"
#include "sim/export/csv_export.hpp"
#include "sim/export/mcap_export.hpp"
#include "sim/replay/explain.hpp"
#include "sim/replay/playback.hpp"
#include "sim/replay/salvage.hpp"
#include "sim/replay/verify.hpp"
#include "sim/view/view_data.hpp"
#include "tests/replay/damaged_run.hpp"

namespace arcbid::testing {
namespace {

constexpr std::size_t page = 4096;

class Damage : public DamagedRun {
 protected:
  /// The report says of every record what SQLite says when it is asked for that one alone.
  LogReport expect_report_is_true(const std::string& damage) {
    const LogReport report = report_of(2);
    const auto found = readable(log, last);
    const auto intact = intact_by(report, last);
    for (const auto& [seq, body] : records) {
      const auto at = found.find(seq);
      const bool as_it_was = at != found.end() && at->second == body;
      if (as_it_was || at == found.end()) {
        EXPECT_EQ(intact.contains(seq), as_it_was) << damage << ": record " << seq;
      }
    }
    EXPECT_EQ(report.records, intact.size()) << damage;
    return report;
  }
  /// Whatever the damage: no crash, and what is salvaged can be used.
  void expect_usable(const std::string& damage) {
    expect_read(run, damage);
    std::filesystem::remove_all(folder / "salvaged");
    salvage(run, examine(run), folder / "salvaged");
    expect_read(folder / "salvaged", damage + ", salvaged");
  }
  /// Every reader of logs either does its work or refuses a log by name.
  void expect_read(const std::filesystem::path& directory, const std::string& damage) {
    const auto attempt = [&](const char* reader, const auto& reads) {
      try {
        reads();
      } catch (const InputError& error) {
        EXPECT_THAT(error.what(), ::testing::HasSubstr(".sqlite")) << reader << ", " << damage;
      }
    };
    attempt("recorded messages", [&] {
      std::size_t said = 0;
      RecordedMessages(directory).play([&](TimeNs, const AgentMessage&) { return ++said > 0; });
      EXPECT_GT(said, 0u) << damage;
    });
    std::optional<RunArchive> archive;
    attempt("archive", [&] { archive = open_run(directory); });
    if (!archive) return;
    attempt("verify", [&] {
      for (const LifeLog& life : archive->lives) verify(life);
    });
    attempt("playback", [&] {
      const Playback playback(*archive);
      playback.owners(playback.moments().size() / 2);
    });
    attempt("explain", [&] { Explainer(*archive, Playback(*archive)); });
    attempt("view", [&] { EXPECT_TRUE(view_data(*archive).contains("auction")) << damage; });
    attempt("mcap", [&] { export_mcap(*archive, folder / "run.mcap"); });
    attempt("csv", [&] { export_csv(*archive, folder / "csv"); });
  }
};

TEST_F(Damage, CutAnywhere) {
  record();
  const std::string whole = bytes_of(log);
  std::size_t most = 0;
  for (std::size_t size = 0; size < whole.size(); size += page / 2 + 100) {
    put_bytes(log, whole.substr(0, size));
    const LogReport report = expect_report_is_true("cut to " + std::to_string(size));
    EXPECT_FALSE(report.whole()) << size;
    expect_read(run, "cut to " + std::to_string(size));
    most = std::max(most, report.records);
  }
  EXPECT_GT(most, records.size() / 2) << "what lies before the cut counts";
  expect_usable("cut");
}

TEST_F(Damage, AnyPageZeroed) {
  record();
  const std::string whole = bytes_of(log);
  std::size_t with_a_gap = 0;
  for (std::size_t at = 0; at < whole.size(); at += page) {
    std::string damaged = whole;
    damaged.replace(at, page, page, '\0');
    put_bytes(log, damaged);
    const LogReport report = expect_report_is_true("page " + std::to_string(at / page));
    expect_read(run, "page " + std::to_string(at / page));
    if (!report.lost.empty() && report.last_seq > report.lost.front().from_seq) ++with_a_gap;
  }
  EXPECT_GT(with_a_gap, whole.size() / page / 2) << "what lies behind the damage counts";
  expect_usable("zeroed");
}

TEST_F(Damage, AnyByteFlipped) {
  record();
  const std::string whole = bytes_of(log);
  Dice dice(7);
  for (int n = 0; n < 80; ++n) {
    std::string damaged = whole;
    const std::size_t at = dice.below(whole.size());
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << dice.below(8)));
    put_bytes(log, damaged);
    const std::string where = "byte " + std::to_string(at);
    for (const std::int64_t seq : intact_by(report_of(2), last))
      EXPECT_TRUE(records.contains(seq)) << where;
    expect_usable(where);
  }
}

TEST_F(Damage, WriteAheadLogCutAnywhere) {
  record_killed();
  const std::string wal = log.string() + "-wal", whole = bytes_of(wal), database = bytes_of(log);
  ASSERT_GT(whole.size(), 10 * page);
  for (std::size_t size = 0; size <= whole.size(); size += page * 3 + 500) {
    put_bytes(log, database);
    put_bytes(wal, whole.substr(0, size));
    std::filesystem::remove(log.string() + "-shm");
    const LogReport report = report_of(2);
    const auto found = readable(log, last);
    EXPECT_EQ(report.records, found.size()) << size;
    EXPECT_EQ(report.wal.lost_commits, 0u) << size;
    expect_read(run, "write-ahead log cut to " + std::to_string(size));
    // Nothing tells a log that was cut from one whose process was killed, but what others heard.
    if (size < whole.size() * 3 / 4) {
      EXPECT_FALSE(report.whole()) << size;
    }
  }
  put_bytes(wal, whole);
  EXPECT_TRUE(report_of(2).whole());
}

TEST_F(Damage, WriteAheadLogFlipped) {
  record_killed();
  const std::string wal = log.string() + "-wal", whole = bytes_of(wal);
  Dice dice(3);
  for (int n = 0; n < 30; ++n) {
    std::string damaged = whole;
    damaged[32 + 24 + dice.below(whole.size() / 2)] ^= 0x10;
    put_bytes(wal, damaged);
    std::filesystem::remove(log.string() + "-shm");
    const LogReport report = report_of(2);
    EXPECT_FALSE(report.whole());
    EXPECT_GT(report.wal.lost_commits, 0u);
    expect_read(run, "write-ahead log flipped");
    EXPECT_EQ(report.records, report.not_read.empty() ? readable(log, last).size() : 0);
  }
}

}  // namespace
}  // namespace arcbid::testing
