// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/auction/agent.hpp"
#include "core/io/run/run_log.hpp"

namespace arcbid {

/// What an agent leaves on record. Rounds do not wait for it: what they leave is kept, and written
/// together within 80 ms (a kill loses no more than that and what RunLog has not committed). A log
/// that can no longer be written costs the log, not the drone.
class AgentLog {
 public:
  using Record =
      std::variant<Event, DecisionMade, Agreement, BidMessage, RelayMessage, StatusMessage>;

  /// `file`: none, and nothing is written. `warn` hears once why writing ended.
  AgentLog(const std::optional<std::filesystem::path>& file,
           std::function<void(const std::string&)> warn);
  /// Writes what is kept.
  ~AgentLog();
  AgentLog(const AgentLog&) = delete;
  AgentLog& operator=(const AgentLog&) = delete;

  void meta(std::string_view key, const nlohmann::json& value);
  /// What a round consumed or produced.
  void keep(TimeNs now_ns, Record what);
  /// Anything else, after all that is kept.
  void write(TimeNs now_ns, std::string_view kind, const nlohmann::json& body);
  /// Writes what has been kept for long enough, and commits.
  void write_if_due(TimeNs now_ns);
  /// When that will be; none: nothing is kept.
  std::optional<TimeNs> due_ns() const;
  /// Writes all that is kept, and commits.
  void commit();

 private:
  struct Kept {
    TimeNs at_ns = 0;
    Record what;
  };
  void write_kept();
  void guarded(const std::function<void(RunLog&)>& act);

  std::optional<RunLog> log_;
  std::function<void(const std::string&)> warn_;
  std::vector<Kept> kept_;
};

}  // namespace arcbid
