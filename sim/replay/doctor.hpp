// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/io/run/run_log_reader.hpp"
#include "core/io/run/wal.hpp"

namespace arcbid {

/// Messages of a life that others heard, or the coordinator, but that are not on its own record.
struct HeardOnly {
  std::size_t messages = 0;
  std::vector<std::pair<std::uint64_t, std::uint64_t>> numbers;  ///< from, to; ascending
  bool behind_its_end = false;       ///< all of them have higher numbers than any on its record
  TimeNs first_ns = 0, last_ns = 0;  ///< when they were heard, each by whoever heard it first
};

/// What one log holds, and what is known to be missing from it.
struct LogReport {
  std::filesystem::path file;  ///< empty: there is none
  std::string role;            ///< "agent" or "coordinator"; empty: nobody knows
  std::uint32_t agent = 0;
  std::uint64_t life = 0;    ///< its incarnation at birth; the coordinator's: its birth's stamp
  std::uint64_t pid = 0;     ///< 0: not known
  std::string not_read;      ///< why nothing of it can be read; empty: it was
  bool never_began = false;  ///< it has no log, or none with anything in it, and nobody heard it
  std::size_t records = 0;   ///< intact ones
  std::int64_t first_seq = 0, last_seq = 0;
  TimeNs first_ns = 0, last_ns = 0;
  std::vector<RunLogReader::Lost> lost;                    ///< ascending
  std::vector<std::string> complaints;                     ///< of SQLite, where it found damage
  std::optional<std::string> other_schema, unread_schema;  ///< LogSchemas
  WalState wal;
  std::optional<std::string> ended_by;  ///< none: killed, its log ends without a word
  std::optional<HeardOnly> heard_only;

  /// All that was committed is there: what a killed process was about to commit is not lost, but
  /// was never on record.
  bool whole() const;
};

/// What a process that is killed may not have committed yet (docs/RUN_DIRECTORY.md).
inline constexpr TimeNs uncommitted_ns = 100'000'000;

struct RunReport {
  std::vector<LogReport> logs;  ///< the coordinator's, then by agent and life; missing ones too
  bool whole() const;
};

/// Looks through every log of a run, as far as it can be read. Throws InputError when `run` is no
/// run directory.
RunReport examine(const std::filesystem::path& run);

/// For people, line by line, and for programs.
std::string describe(const RunReport& report);
nlohmann::json to_json(const RunReport& report);

}  // namespace arcbid
