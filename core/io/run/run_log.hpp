// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/ids.hpp"

namespace arcbid {

/// A kind of record: its name, how its body is written, and what that means.
struct RecordKind {
  std::string name;
  std::string encoding;  ///< "cdr" (core/io/record) or "json"
  std::string schema;    ///< of cdr: the definition in ROS 2's message language
};

/// One process's own event log: a SQLite file with the tables
///   meta(key TEXT PRIMARY KEY, value TEXT)            what is needed to read the rest, as JSON
///   kinds(id INTEGER PRIMARY KEY, name, encoding, schema)  the schema of every record
///   events(seq INTEGER PRIMARY KEY, t_ns INTEGER, kind INTEGER, body BLOB)
/// and a view, log, for people. Records are kept and written together: at the latest 80 ms after
/// the first of them, so that kill -9 costs no more than that and rounds do not wait for a disk.
/// Makes the folder too. Throws InputError when the file cannot be made, RunError when it can no
/// longer be written.
class RunLog {
 public:
  static constexpr int schema = 2;

  explicit RunLog(const std::filesystem::path& file);
  /// Writes what is kept, if it can.
  ~RunLog();

  void meta(std::string_view key, const nlohmann::json& value);
  /// The id under which records of that kind are appended; the same for the same name.
  int kind(const RecordKind& kind);
  void append(TimeNs now_ns, int kind, std::string bytes);
  void append(TimeNs now_ns, std::string_view kind, const nlohmann::json& body);
  /// Under a number of its own, above all before it: to copy a log that has gaps.
  void append_as(std::int64_t seq, TimeNs now_ns, int kind, std::string bytes);
  /// Makes everything so far survive: after results, and before waiting.
  void commit();
  /// Commits what has been kept for long enough.
  void commit_if_due(TimeNs now_ns);
  /// When that will be; none: nothing is kept.
  std::optional<TimeNs> due_ns() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace arcbid
