// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/ids.hpp"
#include "core/faults/schedule.hpp"

namespace arcbid {

enum class ProcessAction : std::uint8_t {
  kill,        ///< SIGKILL
  start,       ///< start it, for the first time or again
  pause,       ///< SIGSTOP
  resume,      ///< SIGCONT
  start_twin,  ///< a second process with the same id
  kill_twin,
};
/// Their names in result.json, in the order of the enumerators.
inline constexpr std::array<std::string_view, 6> process_action_names{
    "kill", "start", "pause", "resume", "start_twin", "kill_twin"};
constexpr std::string_view name_of(ProcessAction action) {
  return process_action_names[static_cast<std::size_t>(action)];
}

/// One thing that the launcher does to a process. Agent 0: the coordinator.
struct ProcessFault {
  TimeNs at_ns = 0;  ///< since launch
  AgentId agent;
  ProcessAction action = ProcessAction::kill;
  friend bool operator==(const ProcessFault&, const ProcessFault&) = default;
};

std::string in_words(const ProcessFault& fault);

/// What a schedule asks of the launcher, in the order of time. Faults of links, clocks and messages
/// are the agents' own affair, but for the time that it takes to say what is malformed.
class FaultScript {
 public:
  explicit FaultScript(const FaultSchedule& schedule);

  /// Whether the agent is not to be started with the others.
  bool comes_late(AgentId agent) const;
  /// Takes the next fault that is due.
  bool next(TimeNs now_ns, ProcessFault& fault);
  /// Whether the process will be started (again) by a fault still to come.
  bool returns(AgentId agent) const;
  /// When the fleet can be done at the earliest: what was done to processes must have happened,
  /// what is malformed must have been said, and the death of one that stays away must have been
  /// noticed. `lease_ns`, `tick_ns`: the auction's.
  TimeNs over_ns(TimeNs lease_ns, TimeNs tick_ns) const;

 private:
  std::vector<ProcessFault> faults_;  // ascending time
  std::vector<AgentFault> spoken_;    // malformed messages
  std::size_t done_ = 0;
};

}  // namespace arcbid
