// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/auction/task_set.hpp"
#include "sim/replay/life_log.hpp"

namespace arcbid {

/// A run directory, opened for replay: what every agent's core consumed and produced. Live runs,
/// recorded worlds, and runs whose processes were killed look the same.
struct RunArchive {
  std::filesystem::path directory;
  std::shared_ptr<const Mission> mission;
  TaskSet tasks;               ///< T, as every agent made it
  std::vector<LifeLog> lives;  ///< of those that had the mission, by agent, then incarnation
  std::vector<std::string> unreadable;  ///< one line for each log that could not be opened, or
                                        ///< whose life never had the mission
  nlohmann::json result;                ///< result.json; null when the run did not come to write it
  bool is_live = false;                 ///< its launcher still runs it
};

/// Opens the logs, several at a time. Throws InputError when no log has a mission, or when they
/// have different ones.
RunArchive open_run(const std::filesystem::path& run);

/// Which of the logs that play cannot be verified and why, one line for each arcbid that wrote
/// some.
std::vector<std::string> unverifiable(const RunArchive& run);

}  // namespace arcbid
