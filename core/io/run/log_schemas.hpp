// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/error.hpp"
#include "core/io/record/records.hpp"
#include "core/io/record/stored_schema.hpp"
#include "core/io/run/run_log_reader.hpp"

namespace arcbid {

/// By which schemas the records of one log are read. Where they are this build's, which they nearly
/// always are, nothing is looked up.
class LogSchemas {
 public:
  explicit LogSchemas(const RunLogReader& log);

  /// Null: this build's.
  const StoredSchema* of(std::string_view kind) const;
  /// Throws InputError: one line with file, record and kind.
  template <class Record>
  Record decode(const RunLogReader::Record& record) const {
    return named(record, [&] { return arcbid::decode<Record>(record.body, of(record.kind)); });
  }
  void decode_into(Step& step, const RunLogReader::Record& record) const {
    named(record, [&] { arcbid::decode_into(step, record.body, of(record.kind)); });
  }

  /// Which arcbid wrote the log: "0.1.0 a8a2cbd"; empty: it does not say.
  const std::string& build() const { return build_; }
  /// Which records have another schema than this build's and in what it differs, and which arcbid
  /// wrote them, in one line without the file's name. The core cannot be run again on these.
  const std::optional<std::string>& other() const { return other_; }
  /// Which schema is none, likewise: it is damaged, or of an arcbid that is much newer. Records are
  /// taken for this build's then, and need not be.
  const std::optional<std::string>& unread() const { return unread_; }
  /// Whether that is so of this kind.
  bool is_unread(std::string_view kind) const;
  /// Throw InputError, one line with the file's name: if there is a schema that is none; if there
  /// is one that is another, so that nothing could be the same bit for bit.
  void demand_read() const;
  void demand_own() const;

 private:
  template <class Decode>
  std::invoke_result_t<Decode> named(const RunLogReader::Record& record, Decode decode) const {
    try {
      return decode();
    } catch (const InputError& error) {
      refuse(record, error.what());
    }
  }
  [[noreturn]] void refuse(const RunLogReader::Record& record, const char* why) const;
  void compare(const RecordKind& kind, const std::string& own, std::string_view name);

  std::filesystem::path file_;
  std::string build_;
  std::vector<std::pair<std::string, StoredSchema>> others_;  // by the names of their kinds
  std::vector<std::string> unread_kinds_;
  std::optional<std::string> other_, unread_;
};

/// Names of logs by their LogSchemas::other().
using OtherLogs = std::map<std::string, std::vector<std::string>>;
/// One line for each arcbid that wrote some: "FILE and 2 more: WHAT: written by ...".
std::vector<std::string> lines_about(const OtherLogs& logs, std::string_view what);

}  // namespace arcbid
