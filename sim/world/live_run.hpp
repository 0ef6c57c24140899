// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/world/spec.hpp"

namespace arcbid {

/// One process of an agent, as its event log shows it. Times are nanoseconds since launch.
struct LiveLife {
  AgentId agent;
  TimeNs born_ns = 0;    ///< when it had the mission: the auction knows no earlier life
  TimeNs last_ns = 0;    ///< when it was last heard of
  std::string ended_by;  ///< coordinator, signal or fault; empty: it did not come to say so
  bool is_twin = false;  ///< a second process with the same id
};

/// Something that the launcher did to an agent's process.
struct LiveAct {
  TimeNs at_ns = 0;
  AgentId agent;
  std::string action;  ///< kill, start, pause, resume, start_twin or kill_twin
};

/// What the directory of a live run, or of a recorded world, says about it (docs/RUN_DIRECTORY.md).
struct LiveRun {
  Mission mission;
  FaultSchedule schedule;       ///< as it was asked for; empty without faults
  std::vector<LiveLife> lives;  ///< of those that had the mission, ascending births
  std::vector<LiveAct> acts;
  std::vector<std::string> left_out;  ///< what has no counterpart in a world, one line each
  std::uint64_t seed = 1;             ///< of a recorded world: under it everything comes out again
  Range<TimeNs> latency_ns{100'000, 5'000'000};  ///< on loopback; a recorded world has its own
  bool is_world = false;                         ///< recorded by `arcbid sim`
};

/// Throws InputError: one line that names what is missing or damaged.
LiveRun read_run(const std::filesystem::path& run);

/// The run's schedule, with what really happened to processes in place of what was to happen: born
/// and dead when they were, deaths that nobody asked for included. Faults of links that have no end
/// end with the run. Throws InputError when nobody was left alive. In a recorded world all went as
/// it was asked for: it is the run's schedule, whoever lived.
FaultSchedule faults_of(const LiveRun& run);

/// The world of that run. The seed varies what a live run does not fix: how long messages take.
/// With a recorded world's own seed it is that world.
WorldSpec world_of(const LiveRun& run, std::uint64_t seed);

}  // namespace arcbid
