// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/ids.hpp"
#include "core/io/run/run_log.hpp"

namespace arcbid {

/// Reads the event log of one process (RunLog), also one whose process was killed or still writes.
/// All of it throws InputError: one line with the file's name.
class RunLogReader {
 public:
  explicit RunLogReader(const std::filesystem::path& file);
  ~RunLogReader();
  RunLogReader(RunLogReader&&) noexcept;

  const std::filesystem::path& file() const;
  /// Null where the log does not say, or that part of it is damaged.
  nlohmann::json meta(std::string_view key) const;
  /// All that it says, by key.
  std::map<std::string, nlohmann::json> meta() const;
  /// In the order in which they came up. A schema that is damaged is empty.
  const std::vector<RecordKind>& kinds() const;

  struct Record {
    std::int64_t seq = 0;
    TimeNs t_ns = 0;        ///< since launch
    std::string_view kind;  ///< its name
    std::string_view body;  ///< valid until the next record is read
  };
  /// Reads records in the order in which they were written, those of `kind` only if it is given,
  /// from `from_seq` on, until `take` returns false.
  void read(const std::function<bool(const Record&)>& take, std::int64_t from_seq = 0,
            std::string_view kind = {}) const;

  /// Records that cannot be read.
  struct Lost {
    std::int64_t from_seq = 0;
    std::optional<std::int64_t> to_seq;  ///< none: all from there on, nobody knows how many
    std::string why;
  };
  /// As read(), but goes on behind what is damaged: `lost` hears of that in its place. Numbers have
  /// no gaps in a sound log.
  void read_intact(const std::function<bool(const Record&)>& take,
                   const std::function<void(const Lost&)>& lost, std::int64_t from_seq = 1) const;
  /// What SQLite's own quick check complains of, a line each; at most a few.
  std::vector<std::string> complaints() const;

  struct Found {
    TimeNs t_ns = 0;
    std::string body;
    nlohmann::json json() const { return nlohmann::json::parse(body, nullptr, false); }
  };
  /// The first record of a kind.
  std::optional<Found> first(std::string_view kind) const;
  /// When the last record was written; 0 when there is none.
  TimeNs last_ns() const;
  std::int64_t last_seq() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace arcbid
