// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace arcbid {

/// What one agent did, recomputed from the waypoints of its route.
struct AgentFigures {
  std::uint32_t agent = 0;
  std::size_t arcs = 0;   ///< arc legs flown
  std::size_t tasks = 0;  ///< tasks it won, by its own table
  double length_m = 0;
  double time_s = 0;  ///< length / the speed that arcs.json gives it
};

/// A stretch that nobody flies, and the reason, which was checked.
struct LeftUndone {
  std::uint32_t arc = 0;
  double from_m = 0, to_m = 0;
  std::string why;   ///< payload, endurance, endurance-left or bundle-limit
  std::string text;  ///< one line for people
};

/// The verdict on a run directory (docs/RUN_DIRECTORY.md lists each rule).
struct CheckReport {
  bool conflict_free = false;   ///< all delivered task tables are one and the same
  bool complete = false;        ///< every task is owned by an agent that delivered a route, or left
                                ///< with a reason that holds
  bool arcs_conserved = false;  ///< tasks, and legs flown, tile every arc exactly once
  bool routes_valid = false;    ///< each route flies, home to home, just what its agent won
  std::vector<std::string> problems;  ///< "<check>: <where>: <what>", a limited number a check

  std::vector<AgentFigures> per_agent;  ///< ascending ids; agents that delivered a readable route
  double makespan_s = 0;
  double total_length_m = 0;
  double uniformity_count = 0;  ///< E of the paper (eq. 18) on tasks won; 0 without agents
  double uniformity_time = 0;   ///< E on flight times in seconds; 0 without agents
  std::size_t arcs = 0;         ///< published
  std::size_t tasks = 0;        ///< in the first agent's table
  std::size_t agents = 0;       ///< that delivered a readable route

  std::vector<LeftUndone> left;  ///< ascending arcs
  double left_m() const;

  /// Nothing is wrong. Whether all was done is another matter.
  bool ok() const { return conflict_free && complete && arcs_conserved && routes_valid; }
  bool all_done() const { return ok() && left.empty(); }
};

/// Checks a run directory with code of its own: it shares none with what made the run. Damaged or
/// missing files are problems in the report; without a readable arcs.json, or without one readable
/// route, nothing is shown and all four verdicts are false.
CheckReport check_run(const std::filesystem::path& run);

/// What is left undone, as check.json and result.json have it.
nlohmann::ordered_json no_bidders_json(const CheckReport& report);

/// The report as JSON text (the run directory's check.json).
std::string to_json(const CheckReport& report);

}  // namespace arcbid
