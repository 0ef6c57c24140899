// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/run/run_log_reader.hpp"

#include <fmt/format.h>

#include <map>

#include "core/base/error.hpp"
#include "core/io/run/sqlite.hpp"

namespace arcbid {

struct RunLogReader::Impl {
  std::filesystem::path file;
  Database db;
  std::vector<RecordKind> kinds;
  std::map<int, std::string> names;

  [[noreturn]] void refuse(const std::string& why) const {
    throw InputError(fmt::format("{}: is not a readable event log: {}", file.string(), why));
  }
  [[noreturn]] void refuse() const { refuse(db ? sqlite3_errmsg(db.get()) : "out of memory"); }

  SqlStatement prepare(const char* sql) const {
    sqlite3_stmt* raw = nullptr;
    if (sqlite3_prepare_v2(db.get(), sql, -1, &raw, nullptr) != SQLITE_OK) refuse();
    return SqlStatement(raw);
  }
  bool next(sqlite3_stmt* statement) const {
    const int result = sqlite3_step(statement);
    if (result != SQLITE_ROW && result != SQLITE_DONE) refuse();
    return result == SQLITE_ROW;
  }
  static std::string_view bytes(sqlite3_stmt* statement, int column) {
    const auto* at = static_cast<const char*>(sqlite3_column_blob(statement, column));
    return {at, static_cast<std::size_t>(sqlite3_column_bytes(statement, column))};
  }
  std::int64_t number(const char* sql) const {
    const SqlStatement statement = prepare(sql);
    return next(statement.get()) ? sqlite3_column_int64(statement.get(), 0) : 0;
  }
  void read_kinds() {
    const SqlStatement rows = prepare("SELECT id, name, encoding, schema FROM kinds ORDER BY id");
    while (next(rows.get())) {
      const auto text = [&](int column) { return std::string(bytes(rows.get(), column)); };
      names[sqlite3_column_int(rows.get(), 0)] = text(1);
      kinds.push_back({text(1), text(2), text(3)});
    }
  }
  int id_of(std::string_view kind) const {
    for (const auto& [id, name] : names)
      if (name == kind) return id;
    return 0;
  }
};

RunLogReader::RunLogReader(const std::filesystem::path& file) : impl_(std::make_unique<Impl>()) {
  impl_->file = file;
  sqlite3* db = nullptr;
  const int opened = sqlite3_open_v2(file.c_str(), &db, SQLITE_OPEN_READONLY, nullptr);
  impl_->db.reset(db);
  if (opened != SQLITE_OK) impl_->refuse();
  const nlohmann::json schema = meta("schema");
  if (schema != RunLog::schema)
    impl_->refuse(fmt::format("its schema is {}, this arcbid reads {}", schema.dump(),
                              static_cast<int>(RunLog::schema)));
  impl_->read_kinds();
}

RunLogReader::~RunLogReader() = default;
RunLogReader::RunLogReader(RunLogReader&&) noexcept = default;

const std::filesystem::path& RunLogReader::file() const {
  return impl_->file;
}

const std::vector<RecordKind>& RunLogReader::kinds() const {
  return impl_->kinds;
}

nlohmann::json RunLogReader::meta(std::string_view key) const {
  const SqlStatement row = impl_->prepare("SELECT value FROM meta WHERE key = ?");
  sqlite3_bind_text(row.get(), 1, key.data(), static_cast<int>(key.size()), SQLITE_STATIC);
  if (!impl_->next(row.get())) return nullptr;
  auto value = nlohmann::json::parse(Impl::bytes(row.get(), 0), nullptr, false);
  if (value.is_discarded()) impl_->refuse(fmt::format("its meta's {} is not JSON", key));
  return value;
}

void RunLogReader::read(const std::function<bool(const Record&)>& take, std::int64_t from_seq,
                        std::string_view kind) const {
  const int only = kind.empty() ? 0 : impl_->id_of(kind);
  if (!kind.empty() && only == 0) return;
  const SqlStatement rows = impl_->prepare(
      kind.empty() ? "SELECT seq, t_ns, kind, body FROM events WHERE seq >= ?1 ORDER BY seq"
                   : "SELECT seq, t_ns, kind, body FROM events WHERE seq >= ?1 AND kind = ?2"
                     " ORDER BY seq");
  sqlite3_bind_int64(rows.get(), 1, from_seq);
  if (only != 0) sqlite3_bind_int(rows.get(), 2, only);
  while (impl_->next(rows.get())) {
    const auto name = impl_->names.find(sqlite3_column_int(rows.get(), 2));
    if (name == impl_->names.end())
      impl_->refuse(
          fmt::format("record {} is of no known kind", sqlite3_column_int64(rows.get(), 0)));
    if (!take({sqlite3_column_int64(rows.get(), 0), sqlite3_column_int64(rows.get(), 1),
               name->second, Impl::bytes(rows.get(), 3)}))
      return;
  }
}

std::optional<RunLogReader::Found> RunLogReader::first(std::string_view kind) const {
  std::optional<Found> found;
  const auto keep = [&found](const Record& record) {
    found = Found{record.t_ns, std::string(record.body)};
    return false;
  };
  read(keep, 0, kind);
  return found;
}

TimeNs RunLogReader::last_ns() const {
  return impl_->number("SELECT t_ns FROM events ORDER BY seq DESC LIMIT 1");
}

std::int64_t RunLogReader::last_seq() const {
  return impl_->number("SELECT max(seq) FROM events");
}

}  // namespace arcbid
