// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/run/run_log.hpp"

#include <fmt/format.h>

#include <map>

#include "core/base/error.hpp"
#include "core/io/run/sqlite.hpp"

namespace arcbid {
namespace {

constexpr TimeNs commit_interval_ns = 80'000'000;

// WAL and NORMAL: a killed process loses nothing committed; only a power cut could.
constexpr const char* layout =
    "PRAGMA journal_mode=WAL; PRAGMA synchronous=NORMAL;"
    "CREATE TABLE IF NOT EXISTS meta(key TEXT PRIMARY KEY, value TEXT NOT NULL);"
    "CREATE TABLE IF NOT EXISTS kinds(id INTEGER PRIMARY KEY, name TEXT NOT NULL,"
    " encoding TEXT NOT NULL, schema TEXT NOT NULL);"
    "CREATE TABLE IF NOT EXISTS events(seq INTEGER PRIMARY KEY, t_ns INTEGER NOT NULL,"
    " kind INTEGER NOT NULL, body BLOB NOT NULL);"
    "CREATE VIEW IF NOT EXISTS log AS SELECT seq, t_ns, name AS kind, encoding, body"
    " FROM events JOIN kinds ON kinds.id = events.kind;";

}  // namespace

struct RunLog::Impl {
  struct Kept {
    TimeNs at_ns;
    int kind;
    std::string bytes;
    std::optional<std::int64_t> seq = std::nullopt;  // none: the next one
  };
  std::string file;
  Database db;
  SqlStatement insert, insert_meta, insert_kind;
  std::map<std::string, int, std::less<>> kinds;
  std::vector<std::pair<std::string, std::string>> kept_meta;
  std::vector<std::pair<int, RecordKind>> kept_kinds;
  std::vector<Kept> kept;

  std::string what_failed(const char* what) const {
    return fmt::format("{}: cannot {} the event log: {}", file, what,
                       db ? sqlite3_errmsg(db.get()) : "out of memory");
  }
  [[noreturn]] void fail_to_write() const { throw RunError(what_failed("write")); }
  void run(const char* sql) {
    if (sqlite3_exec(db.get(), sql, nullptr, nullptr, nullptr) != SQLITE_OK) fail_to_write();
  }
  SqlStatement prepare(const char* sql) {
    sqlite3_stmt* statement = nullptr;
    if (sqlite3_prepare_v2(db.get(), sql, -1, &statement, nullptr) != SQLITE_OK) fail_to_write();
    return SqlStatement(statement);
  }
  void execute(sqlite3_stmt* statement) {
    const int result = sqlite3_step(statement);
    sqlite3_reset(statement);
    if (result != SQLITE_DONE) fail_to_write();
  }
  // What is bound lives until the statement was executed.
  static void bind(sqlite3_stmt* statement, int at, std::string_view text) {
    sqlite3_bind_text(statement, at, text.data(), static_cast<int>(text.size()), SQLITE_STATIC);
  }
  void write_all() {
    for (const auto& [key, value] : kept_meta) {
      bind(insert_meta.get(), 1, key);
      bind(insert_meta.get(), 2, value);
      execute(insert_meta.get());
    }
    for (const auto& [id, kind] : kept_kinds) {
      sqlite3_bind_int(insert_kind.get(), 1, id);
      bind(insert_kind.get(), 2, kind.name);
      bind(insert_kind.get(), 3, kind.encoding);
      bind(insert_kind.get(), 4, kind.schema);
      execute(insert_kind.get());
    }
    for (const Kept& record : kept) {
      sqlite3_bind_int64(insert.get(), 1, record.at_ns);
      sqlite3_bind_int(insert.get(), 2, record.kind);
      if (record.seq)
        sqlite3_bind_int64(insert.get(), 4, *record.seq);
      else
        sqlite3_bind_null(insert.get(), 4);
      sqlite3_bind_blob64(insert.get(), 3, record.bytes.data(), record.bytes.size(), SQLITE_STATIC);
      execute(insert.get());
    }
  }
};

RunLog::RunLog(const std::filesystem::path& file) : impl_(std::make_unique<Impl>()) {
  impl_->file = file.string();
  std::error_code failed;
  std::filesystem::create_directories(file.parent_path(), failed);
  if (failed)
    throw InputError(
        fmt::format("{}: cannot be made: {}", file.parent_path().string(), failed.message()));
  sqlite3* db = nullptr;
  const int opened = sqlite3_open(impl_->file.c_str(), &db);
  impl_->db.reset(db);
  if (opened != SQLITE_OK) throw InputError(impl_->what_failed("open"));
  impl_->run(layout);
  impl_->insert = impl_->prepare("INSERT INTO events(t_ns, kind, body, seq) VALUES(?, ?, ?, ?)");
  impl_->insert_meta = impl_->prepare("INSERT OR REPLACE INTO meta(key, value) VALUES(?, ?)");
  impl_->insert_kind = impl_->prepare("INSERT OR REPLACE INTO kinds VALUES(?, ?, ?, ?)");
}

RunLog::~RunLog() {
  // A destructor must not throw; what can't be committed now was lost with the disk.
  try {
    commit();
  } catch (const RunError&) {
  }
}

void RunLog::meta(std::string_view key, const nlohmann::json& value) {
  impl_->kept_meta.emplace_back(key, value.dump());
}

int RunLog::kind(const RecordKind& kind) {
  const auto next = static_cast<int>(impl_->kinds.size()) + 1;
  const auto [at, is_new] = impl_->kinds.try_emplace(kind.name, next);
  if (is_new) impl_->kept_kinds.emplace_back(next, kind);
  return at->second;
}

void RunLog::append(TimeNs now_ns, int kind, std::string bytes) {
  impl_->kept.push_back({now_ns, kind, std::move(bytes)});
}

void RunLog::append_as(std::int64_t seq, TimeNs now_ns, int kind, std::string bytes) {
  impl_->kept.push_back({now_ns, kind, std::move(bytes), seq});
}

void RunLog::append(TimeNs now_ns, std::string_view name, const nlohmann::json& body) {
  append(now_ns, kind({std::string(name), "json", ""}), body.dump());
}

void RunLog::commit() {
  if (impl_->kept.empty() && impl_->kept_meta.empty() && impl_->kept_kinds.empty()) return;
  impl_->run("BEGIN");
  impl_->write_all();
  impl_->run("COMMIT");
  impl_->kept.clear();
  impl_->kept_meta.clear();
  impl_->kept_kinds.clear();
}

std::optional<TimeNs> RunLog::due_ns() const {
  if (impl_->kept.empty()) return std::nullopt;
  return impl_->kept.front().at_ns + commit_interval_ns;
}

void RunLog::commit_if_due(TimeNs now_ns) {
  const auto due = due_ns();
  if (due && now_ns >= *due) commit();
}

}  // namespace arcbid
