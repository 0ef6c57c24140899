// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string_view>

#include "core/base/ids.hpp"

namespace arcbid {

/// One process's own event log: a SQLite file with the tables
///   meta(key TEXT PRIMARY KEY, value TEXT)  what is needed to read the rest
///   events(seq INTEGER PRIMARY KEY, t_ns INTEGER, kind TEXT, body TEXT)  body is JSON
/// Committed at least every 50 ms while events come, so that kill -9 costs no more than that.
/// Makes the folder too. Throws InputError when the file cannot be made, RunError when it can no
/// longer be written.
class RunLog {
 public:
  explicit RunLog(const std::filesystem::path& file);
  ~RunLog();

  void meta(std::string_view key, const nlohmann::json& value);
  void append(TimeNs now_ns, std::string_view kind, const nlohmann::json& body);
  /// Makes everything so far survive: after results, and before waiting.
  void commit();
  /// Commits when the last commit is 50 ms ago or more.
  void commit_if_due(TimeNs now_ns);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace arcbid
