// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "core/arcs/mission.hpp"
#include "core/auction/task_set.hpp"

namespace arcbid {

/// A task-allocation instance of points: agents at places, tasks at places, values. Metres.
struct Instance {
  std::vector<Uav> fleet;  ///< ids are the file's `agent` + 1, for agent ids start at 1
  TaskSet tasks;           ///< points without length; paths end at their last task
};

/// Reads `agents` (columns agent,x,y,z,speed: 0, 1, 2 … in order) and `tasks` (columns task,x,y,z
/// and `value_column`: likewise). Throws InputError that names the file and line.
Instance read_instance(const std::filesystem::path& agents, const std::filesystem::path& tasks,
                       const std::string& value_column);

}  // namespace arcbid
