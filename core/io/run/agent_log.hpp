// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/record/records.hpp"
#include "core/io/run/run_log.hpp"

namespace arcbid {

/// Names of the kinds that others go by.
namespace log_kind {
inline constexpr std::string_view mission = "mission", birth = "birth", step = "step",
                                  route = "route", heard_status = "heard_status", end = "end",
                                  lost = "lost", fate = "fate";
}  // namespace log_kind

/// What one life of an agent leaves on record: all that its core consumed and produced, and what
/// else happened to it. A log that can no longer be written costs the log, not the drone.
class AgentLog {
 public:
  struct Life {
    AgentId agent;
    std::uint64_t incarnation = 0;
    std::uint64_t seed = 0;  ///< of the world, where one was drawn; 0: live
  };
  /// `file`: none, and nothing is written. `warn` hears once why writing ended.
  AgentLog(const std::optional<std::filesystem::path>& file, const Life& life,
           std::function<void(const std::string&)> warn);
  AgentLog(const AgentLog&) = delete;
  AgentLog& operator=(const AgentLog&) = delete;

  void birth(TimeNs now_ns, const Birth& birth, const Mission& mission);
  void step(TimeNs now_ns, const Step& step);
  void route(TimeNs now_ns, const PlannedRoute& route);
  /// What the faults of links did to a message that came at `now_ns`: when each copy of it is heard
  /// (ascending), none: it is lost. Of one that nothing was done to nothing is written.
  void fate(TimeNs now_ns, const Header& header, const std::vector<TimeNs>& arrivals_ns);
  /// Anything else.
  void write(TimeNs now_ns, std::string_view kind, const nlohmann::json& body);

  /// RunLog's.
  void commit_if_due(TimeNs now_ns);
  std::optional<TimeNs> due_ns() const;
  void commit();

 private:
  template <class Record>
  void append(TimeNs now_ns, std::string_view name, int& kind, const Record& record);
  void guarded(const std::function<void(RunLog&)>& act);

  std::optional<RunLog> log_;
  std::function<void(const std::string&)> warn_;
  int birth_ = 0, mission_ = 0, step_ = 0, route_ = 0;  // kinds; 0: not yet said
};

/// How records of a type are kept, under that name.
template <class Record>
RecordKind cdr_kind(std::string_view name) {
  return {std::string(name), "cdr", schema_of<Record>()};
}

}  // namespace arcbid
