// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "core/io/record/records.hpp"
#include "core/io/run/log_schemas.hpp"
#include "core/io/run/run_log_reader.hpp"

namespace arcbid {

using AgentMessage = std::variant<BidMessage, RelayMessage, StatusMessage>;

/// All that the agents of a run said, as their logs have it.
class RecordedMessages {
 public:
  /// Throws InputError: one line, when no log has the mission and what was said about it, or when
  /// logs have different missions.
  explicit RecordedMessages(const std::filesystem::path& run);

  const Mission& mission() const { return mission_; }
  std::vector<AgentId> fleet() const;
  std::size_t steps() const { return steps_.size(); }
  /// One line each: logs that cannot be read, and what a damaged one has lost. Damage are also
  /// records that still read and hold what no agent of the mission can have said.
  const std::vector<std::string>& left_out() const { return left_out_; }
  /// One line for each other arcbid whose records these are: what is said again is this build's,
  /// but digests are as they were said, and a listener of this build need not know them.
  std::vector<std::string> of_other_builds() const;
  /// In the order of the logs' times, until `take` returns false. It goes on behind what is
  /// damaged.
  void play(const std::function<bool(TimeNs t_ns, const AgentMessage& message)>& take) const;

 private:
  struct Place {
    TimeNs t_ns = 0;
    std::size_t log = 0;
    std::int64_t seq = 0;
    friend auto operator<=>(const Place&, const Place&) = default;
  };
  struct Log {
    std::unique_ptr<RunLogReader> reader;
    LogSchemas schemas;
  };
  void read(const std::filesystem::path& file);

  Mission mission_;
  std::vector<Log> logs_;
  std::vector<Place> steps_;
  std::vector<std::string> left_out_;
  OtherLogs others_;
};

}  // namespace arcbid
