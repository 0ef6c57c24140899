// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "sim/replay/explain.hpp"

namespace arcbid {

/// A run directory with all that is made of it.
struct OpenRun {
  explicit OpenRun(const std::filesystem::path& directory) : run(open_run(directory)) {}
  OpenRun(const OpenRun&) = delete;
  OpenRun& operator=(const OpenRun&) = delete;

  RunArchive run;
  Playback playback{run};
  Explainer explainer{run, playback};
};

/// What is different between two runs.
struct RunDiff {
  std::vector<std::string> settings;  ///< of the missions, one line each; none: the same mission
  bool same_tasks = true;             ///< else nothing below is told

  /// The first round in which an agent decided something else.
  struct Parting {
    AgentId agent;
    std::uint32_t round = 0;
    TaskId task;                               ///< the first one in its bundle that differs
    std::array<std::optional<double>, 2> bid;  ///< its bid for it in both; none: no bid
    std::array<TimeNs, 2> t_ns{};
    /// What it held of the others that was not the same; none: chance had no part in it.
    std::vector<std::string> before;
  };
  std::optional<Parting> parting;

  std::vector<TaskId> owners;  ///< tasks with another last owner
  struct Figure {
    std::string name;
    std::array<std::optional<double>, 2> value;  ///< none: not on record
  };
  std::vector<Figure> figures;

  bool same_allocation() const { return same_tasks && owners.empty(); }
};

RunDiff diff(const OpenRun& a, const OpenRun& b);

}  // namespace arcbid
