// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/replay/damaged_run.hpp"

#include <sqlite3.h>
#include <stdlib.h>

#include <fstream>

namespace arcbid::testing {

namespace fs = std::filesystem;

std::map<std::int64_t, std::string> readable(const fs::path& log, std::int64_t most) {
  std::map<std::int64_t, std::string> out;
  sqlite3* db = nullptr;
  sqlite3_open_v2(log.c_str(), &db, SQLITE_OPEN_READONLY, nullptr);
  sqlite3_exec(db, "PRAGMA writable_schema = ON", nullptr, nullptr, nullptr);
  sqlite3_stmt *event = nullptr, *kind = nullptr;
  sqlite3_prepare_v2(db, "SELECT kind, body FROM events WHERE seq = ?", -1, &event, nullptr);
  sqlite3_prepare_v2(db, "SELECT name FROM kinds WHERE id = ?", -1, &kind, nullptr);
  for (std::int64_t seq = 1; event && kind && seq <= most; ++seq) {
    sqlite3_bind_int64(event, 1, seq);
    if (sqlite3_step(event) == SQLITE_ROW) {
      const auto* body = static_cast<const char*>(sqlite3_column_blob(event, 1));
      const auto size = static_cast<std::size_t>(sqlite3_column_bytes(event, 1));
      sqlite3_bind_int(kind, 1, sqlite3_column_int(event, 0));
      if (sqlite3_step(kind) == SQLITE_ROW) out[seq] = std::string(body, size);
      sqlite3_reset(kind);
    }
    sqlite3_reset(event);
  }
  sqlite3_finalize(event);
  sqlite3_finalize(kind);
  sqlite3_close_v2(db);
  return out;
}

std::string bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void put_bytes(const fs::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
}

void put_record(const fs::path& log, std::int64_t seq, const std::string& body) {
  sqlite3* db = nullptr;
  sqlite3_open(log.c_str(), &db);
  sqlite3_stmt* update = nullptr;
  sqlite3_prepare_v2(db, "UPDATE events SET body = ? WHERE seq = ?", -1, &update, nullptr);
  sqlite3_bind_blob(update, 1, body.data(), static_cast<int>(body.size()), SQLITE_STATIC);
  sqlite3_bind_int64(update, 2, seq);
  EXPECT_EQ(sqlite3_step(update), SQLITE_DONE);
  sqlite3_finalize(update);
  sqlite3_close_v2(db);
}

std::set<std::int64_t> intact_by(const LogReport& report, std::int64_t most) {
  std::set<std::int64_t> out;
  if (!report.not_read.empty()) return out;
  for (std::int64_t seq = 1; seq <= most && seq <= report.last_seq; ++seq) out.insert(seq);
  for (const auto& lost : report.lost)
    out.erase(out.lower_bound(lost.from_seq),
              lost.to_seq ? out.upper_bound(*lost.to_seq) : out.end());
  return out;
}

DamagedRun::DamagedRun() {
  std::string name = (fs::temp_directory_path() / "arcbid-doctor-XXXXXX").string();
  folder = mkdtemp(name.data());
  run = folder / "run";
}

DamagedRun::~DamagedRun() {
  fs::remove_all(folder);
}

void DamagedRun::record(std::uint32_t arcs) {
  RecordedRun recorded(run, random_mission(4, 3, arcs));
  recorded.run_for(12'000'000'000);
  log = recorded.log({2});
  recorded.end();
  records = readable(log, 100'000);
  last = records.rbegin()->first;
}

void DamagedRun::record_killed() {
  RecordedRun recorded(run, random_mission(4, 3, 20));
  recorded.run_for(6'000'000'000);
  log = recorded.log({2});
  recorded.kill({2});
  recorded.run_for(3'000'000'000);
  recorded.end();
  records = readable(log, 100'000);
  last = records.rbegin()->first;
}

LogReport DamagedRun::report_of(std::uint32_t agent) const {
  for (const LogReport& log_report : examine(run).logs)
    if (log_report.agent == agent) return log_report;
  ADD_FAILURE() << "no report of agent " << agent;
  return {};
}

}  // namespace arcbid::testing
