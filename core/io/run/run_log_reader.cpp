// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/run/run_log_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/base/error.hpp"
#include "core/io/run/sqlite.hpp"

namespace arcbid {

struct RunLogReader::Impl {
  std::filesystem::path file;
  Database db;
  std::map<std::string, std::string> meta;
  bool meta_is_damaged = false;
  std::map<int, std::string> names;
  std::vector<RecordKind> kinds;

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
  void read_meta() {
    const SqlStatement rows = prepare("SELECT key, value FROM meta NOT INDEXED");
    int result = SQLITE_DONE;
    while ((result = sqlite3_step(rows.get())) == SQLITE_ROW)
      meta[std::string(bytes(rows.get(), 0))] = bytes(rows.get(), 1);
    meta_is_damaged = result == SQLITE_CORRUPT;
    if (result != SQLITE_DONE && !meta_is_damaged) refuse();
  }
  /// One by one, and their schemas apart, for these fill most pages: damage is to cost what lies on
  /// it and no more.
  void read_kinds() {
    constexpr int most = 100;
    const SqlStatement kind = prepare("SELECT name, encoding FROM kinds WHERE id = ?");
    const SqlStatement schema = prepare("SELECT schema FROM kinds WHERE id = ?");
    for (int id = 1; id <= most; ++id) {
      sqlite3_bind_int(kind.get(), 1, id);
      sqlite3_bind_int(schema.get(), 1, id);
      if (sqlite3_step(kind.get()) == SQLITE_ROW) {
        names[id] = bytes(kind.get(), 0);
        kinds.push_back({names[id], std::string(bytes(kind.get(), 1)), ""});
        if (sqlite3_step(schema.get()) == SQLITE_ROW) kinds.back().schema = bytes(schema.get(), 0);
      }
      sqlite3_reset(kind.get());
      sqlite3_reset(schema.get());
    }
  }
  int id_of(std::string_view name) const {
    for (const auto& [id, known] : names)
      if (known == name) return id;
    return 0;
  }
  /// No record has a higher number: each takes more than 16 bytes. What was salvaged has gaps, and
  /// says where it ends.
  std::int64_t most_seq(const nlohmann::json& last_seq) const {
    std::error_code none;
    std::uintmax_t size = 0;
    for (const char* part : {"", "-wal"}) {
      const auto bytes_there = std::filesystem::file_size(file.string() + part, none);
      if (!none) size += bytes_there;
    }
    const auto by_size = static_cast<std::int64_t>(size / 16);
    return last_seq.is_number_integer() ? std::max(by_size, last_seq.get<std::int64_t>()) : by_size;
  }
  /// The first record of that number or a higher one that can be found by itself.
  std::optional<std::int64_t> found_from(std::int64_t seq, std::int64_t most) const {
    const SqlStatement one = prepare("SELECT seq FROM events WHERE seq = ?");
    for (; seq <= most; ++seq) {
      sqlite3_bind_int64(one.get(), 1, seq);
      const int result = sqlite3_step(one.get());
      const bool found = result == SQLITE_ROW && sqlite3_column_int64(one.get(), 0) == seq;
      sqlite3_reset(one.get());
      if (found) return seq;
    }
    return std::nullopt;
  }
};

RunLogReader::RunLogReader(const std::filesystem::path& file) : impl_(std::make_unique<Impl>()) {
  impl_->file = file;
  std::error_code failed;
  // SQLite would delete the write-ahead log of an empty file.
  if (std::filesystem::file_size(file, failed) == 0 && !failed) impl_->refuse("it is empty");
  sqlite3* db = nullptr;
  const int opened = sqlite3_open_v2(file.c_str(), &db, SQLITE_OPEN_READONLY, nullptr);
  impl_->db.reset(db);
  if (opened != SQLITE_OK) impl_->refuse();
  // Else SQLite refuses a file that is shorter than it should be. Nothing is written here anyway.
  sqlite3_exec(db, "PRAGMA writable_schema = ON", nullptr, nullptr, nullptr);
  impl_->read_meta();
  const nlohmann::json schema = meta("schema");
  const bool is_lost = impl_->meta_is_damaged && schema.is_null();
  if (!is_lost && schema != RunLog::schema)
    impl_->refuse(fmt::format("its schema is {}, this arcbid reads {}", schema.dump(),
                              static_cast<int>(RunLog::schema)));
  // Logs are only ever appended to: pages are read where they are, instead of one call each.
  sqlite3_exec(db, "PRAGMA mmap_size = 4294967296", nullptr, nullptr, nullptr);
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
  const auto at = impl_->meta.find(std::string(key));
  if (at == impl_->meta.end()) return nullptr;
  auto value = nlohmann::json::parse(at->second, nullptr, false);
  if (value.is_discarded()) impl_->refuse(fmt::format("its meta's {} is not JSON", key));
  return value;
}

std::map<std::string, nlohmann::json> RunLogReader::meta() const {
  std::map<std::string, nlohmann::json> out;
  for (const auto& [key, text] : impl_->meta) out[key] = meta(key);
  return out;
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

void RunLogReader::read_intact(const std::function<bool(const Record&)>& take,
                               const std::function<void(const Lost&)>& lost,
                               std::int64_t from_seq) const {
  const std::int64_t most = impl_->most_seq(meta("last_seq"));
  std::optional<std::int64_t> next = std::max<std::int64_t>(from_seq, 1);
  while (next) {
    const SqlStatement rows =
        impl_->prepare("SELECT seq, t_ns, kind, body FROM events WHERE seq >= ? ORDER BY seq");
    sqlite3_bind_int64(rows.get(), 1, *next);
    int result = SQLITE_DONE;
    while ((result = sqlite3_step(rows.get())) == SQLITE_ROW) {
      const std::int64_t seq = sqlite3_column_int64(rows.get(), 0);
      // A record whose own number is damaged must not hide those behind it.
      const bool misplaced = seq < *next || seq > most;
      if (misplaced || (seq > *next + 1 && impl_->found_from(*next + 1, *next + 1))) break;
      if (seq > *next) lost({*next, seq - 1, "they are not there"});
      next = seq + 1;
      const auto name = impl_->names.find(sqlite3_column_int(rows.get(), 2));
      if (name == impl_->names.end())
        lost({seq, seq, "of no known kind"});
      else if (!take({seq, sqlite3_column_int64(rows.get(), 1), name->second,
                      Impl::bytes(rows.get(), 3)}))
        return;
    }
    if (result == SQLITE_DONE) return;
    const std::string why = result == SQLITE_ROW ? "out of order" : sqlite3_errmsg(impl_->db.get());
    const std::int64_t from = *next;
    next = impl_->found_from(from + 1, most);
    lost({from, next ? std::optional(*next - 1) : std::nullopt, why});
  }
}

std::vector<std::string> RunLogReader::complaints() const {
  std::vector<std::string> out;
  const SqlStatement rows = impl_->prepare("PRAGMA quick_check(3)");
  int result = SQLITE_DONE;
  while ((result = sqlite3_step(rows.get())) == SQLITE_ROW) {
    std::string line(Impl::bytes(rows.get(), 0));
    std::replace(line.begin(), line.end(), '\n', ' ');
    if (line != "ok") out.push_back(std::move(line));
  }
  if (result != SQLITE_DONE) out.emplace_back(sqlite3_errmsg(impl_->db.get()));
  return out;
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
