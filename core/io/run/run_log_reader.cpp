// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/run/run_log_reader.hpp"

#include <fmt/format.h>
#include <sqlite3.h>

#include "core/base/error.hpp"

namespace arcbid {
namespace {

struct CloseDatabase {
  void operator()(sqlite3* db) const { sqlite3_close_v2(db); }
};
struct Finalize {
  void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};

}  // namespace

struct RunLogReader::Impl {
  std::string file;
  std::unique_ptr<sqlite3, CloseDatabase> db;

  [[noreturn]] void refuse(const std::string& why) const {
    throw InputError(fmt::format("{}: is not a readable event log: {}", file, why));
  }
  [[noreturn]] void refuse() const { refuse(db ? sqlite3_errmsg(db.get()) : "out of memory"); }

  /// A query whose only parameter is `value`, at its first row; null when there is none.
  std::unique_ptr<sqlite3_stmt, Finalize> row(const char* sql, std::string_view value) const {
    sqlite3_stmt* raw = nullptr;
    if (sqlite3_prepare_v2(db.get(), sql, -1, &raw, nullptr) != SQLITE_OK) refuse();
    std::unique_ptr<sqlite3_stmt, Finalize> statement(raw);
    if (sqlite3_bind_parameter_count(raw) > 0)
      sqlite3_bind_text(raw, 1, value.data(), static_cast<int>(value.size()), SQLITE_TRANSIENT);
    const int result = sqlite3_step(raw);
    if (result != SQLITE_ROW && result != SQLITE_DONE) refuse();
    if (result == SQLITE_DONE) statement.reset();
    return statement;
  }

  static std::string text(sqlite3_stmt* statement, int column) {
    const auto* bytes = reinterpret_cast<const char*>(sqlite3_column_text(statement, column));
    return bytes == nullptr ? "" : std::string(bytes);
  }

  nlohmann::json json(sqlite3_stmt* statement, int column, const std::string& what) const {
    auto value = nlohmann::json::parse(text(statement, column), nullptr, false);
    if (value.is_discarded()) refuse(what + " is not JSON");
    return value;
  }

  std::optional<Event> event(const char* sql, std::string_view kind) const {
    const auto found = row(sql, kind);
    if (!found) return std::nullopt;
    Event event{sqlite3_column_int64(found.get(), 0), text(found.get(), 1), {}};
    event.body = json(found.get(), 2, "an event of kind " + event.kind);
    return event;
  }
};

RunLogReader::RunLogReader(const std::filesystem::path& file) : impl_(std::make_unique<Impl>()) {
  impl_->file = file.string();
  sqlite3* db = nullptr;
  const int opened =
      sqlite3_open_v2(impl_->file.c_str(), &db, SQLITE_OPEN_READONLY, nullptr);
  impl_->db.reset(db);
  if (opened != SQLITE_OK) impl_->refuse();
}

RunLogReader::~RunLogReader() = default;

nlohmann::json RunLogReader::meta(std::string_view key) const {
  const auto found = impl_->row("SELECT value FROM meta WHERE key = ?", key);
  if (!found) impl_->refuse(fmt::format("its meta has no {}", key));
  return impl_->json(found.get(), 0, fmt::format("its meta's {}", key));
}

std::optional<RunLogReader::Event> RunLogReader::first(std::string_view kind) const {
  return impl_->event("SELECT t_ns, kind, body FROM events WHERE kind = ? ORDER BY seq LIMIT 1",
                      kind);
}

std::optional<RunLogReader::Event> RunLogReader::last() const {
  return impl_->event("SELECT t_ns, kind, body FROM events ORDER BY seq DESC LIMIT 1", {});
}

}  // namespace arcbid
