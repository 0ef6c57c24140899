// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/run/run_log.hpp"

#include <fmt/format.h>
#include <sqlite3.h>

#include <string>

#include "core/base/error.hpp"

namespace arcbid {
namespace {

constexpr TimeNs commit_interval_ns = 50'000'000;

struct CloseDatabase {
  void operator()(sqlite3* db) const { sqlite3_close_v2(db); }
};
struct Finalize {
  void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};

}  // namespace

struct RunLog::Impl {
  std::string file;
  std::unique_ptr<sqlite3, CloseDatabase> db;
  std::unique_ptr<sqlite3_stmt, Finalize> insert, insert_meta;
  bool open_transaction = false;
  TimeNs committed_ns = 0;

  std::string what_failed(const char* what) const {
    return fmt::format("{}: cannot {} the event log: {}", file, what,
                       db ? sqlite3_errmsg(db.get()) : "out of memory");
  }
  [[noreturn]] void fail_to_write() const { throw RunError(what_failed("write")); }
  void run(const char* sql) {
    if (sqlite3_exec(db.get(), sql, nullptr, nullptr, nullptr) != SQLITE_OK) fail_to_write();
  }
  std::unique_ptr<sqlite3_stmt, Finalize> prepare(const char* sql) {
    sqlite3_stmt* statement = nullptr;
    if (sqlite3_prepare_v2(db.get(), sql, -1, &statement, nullptr) != SQLITE_OK) fail_to_write();
    return std::unique_ptr<sqlite3_stmt, Finalize>(statement);
  }
  void begin() {
    if (!open_transaction) run("BEGIN");
    open_transaction = true;
  }
  void execute(sqlite3_stmt* statement) {
    const int result = sqlite3_step(statement);
    sqlite3_reset(statement);
    if (result != SQLITE_DONE) fail_to_write();
  }
  static void bind(sqlite3_stmt* statement, int at, std::string_view text) {
    sqlite3_bind_text(statement, at, text.data(), static_cast<int>(text.size()), SQLITE_TRANSIENT);
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
  // WAL and NORMAL: a killed process loses nothing committed; only a power cut could.
  impl_->run("PRAGMA journal_mode=WAL; PRAGMA synchronous=NORMAL;");
  impl_->run(
      "CREATE TABLE IF NOT EXISTS meta(key TEXT PRIMARY KEY, value TEXT NOT NULL);"
      "CREATE TABLE IF NOT EXISTS events(seq INTEGER PRIMARY KEY, t_ns INTEGER NOT NULL,"
      " kind TEXT NOT NULL, body TEXT NOT NULL);");
  impl_->insert = impl_->prepare("INSERT INTO events(t_ns, kind, body) VALUES(?, ?, ?)");
  impl_->insert_meta = impl_->prepare("INSERT OR REPLACE INTO meta(key, value) VALUES(?, ?)");
}

RunLog::~RunLog() {
  // A destructor must not throw; what can't be committed now was lost with the disk.
  if (impl_->open_transaction) sqlite3_exec(impl_->db.get(), "COMMIT", nullptr, nullptr, nullptr);
}

void RunLog::meta(std::string_view key, const nlohmann::json& value) {
  impl_->begin();
  const std::string text = value.dump();
  Impl::bind(impl_->insert_meta.get(), 1, key);
  Impl::bind(impl_->insert_meta.get(), 2, text);
  impl_->execute(impl_->insert_meta.get());
}

void RunLog::append(TimeNs now_ns, std::string_view kind, const nlohmann::json& body) {
  impl_->begin();
  const std::string text = body.dump();
  sqlite3_bind_int64(impl_->insert.get(), 1, now_ns);
  Impl::bind(impl_->insert.get(), 2, kind);
  Impl::bind(impl_->insert.get(), 3, text);
  impl_->execute(impl_->insert.get());
}

void RunLog::commit() {
  if (impl_->open_transaction) impl_->run("COMMIT");
  impl_->open_transaction = false;
}

void RunLog::commit_if_due(TimeNs now_ns) {
  if (now_ns - impl_->committed_ns < commit_interval_ns) return;
  commit();
  impl_->committed_ns = now_ns;
}

}  // namespace arcbid
