// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <variant>
#include <vector>

#include "core/io/record/records.hpp"
#include "core/io/run/run_log_reader.hpp"

namespace arcbid {

using AgentMessage = std::variant<BidMessage, RelayMessage, StatusMessage>;

/// All that the agents of a run said, as their logs have it.
class RecordedMessages {
 public:
  /// Throws InputError: one line, when no log has a mission.
  explicit RecordedMessages(const std::filesystem::path& run);

  const Mission& mission() const { return mission_; }
  std::vector<AgentId> fleet() const;
  std::size_t steps() const { return steps_.size(); }
  /// In the order of the logs' times, until `take` returns false. A damaged log ends early.
  void play(const std::function<bool(TimeNs t_ns, const AgentMessage& message)>& take) const;

 private:
  struct Place {
    TimeNs t_ns = 0;
    std::size_t log = 0;
    std::int64_t seq = 0;
    friend auto operator<=>(const Place&, const Place&) = default;
  };
  void read(const std::filesystem::path& file);

  Mission mission_;
  std::vector<std::unique_ptr<RunLogReader>> logs_;
  std::vector<Place> steps_;
};

}  // namespace arcbid
