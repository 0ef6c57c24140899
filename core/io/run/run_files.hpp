// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "core/arcs/mission.hpp"
#include "core/auction/agent.hpp"
#include "core/route/route.hpp"
#include "core/structure/structure.hpp"

namespace arcbid {

/// The files of a run directory (docs/RUN_DIRECTORY.md). Each appears whole or not at all: it is
/// written beside its place and renamed. Throw InputError when the place cannot be written to at
/// all, RunError when writing fails on the way.
void write_arcs_file(const std::filesystem::path& run, const Mission& mission);

/// structure.ply: what the arcs were made for, as whoever looks at the run is shown it.
void write_structure_file(const std::filesystem::path& run, const Structure& structure);

/// `owners`: who flies each task after exchanges. `time_s`: when agreement was proven, since
/// launch.
void write_route_file(const std::filesystem::path& run, AgentId agent, const Mission& mission,
                      const TaskSet& tasks, const Agreement& agreement,
                      const std::vector<std::optional<AgentId>>& owners, const Route& route,
                      double time_s);

std::filesystem::path route_file(const std::filesystem::path& run, AgentId agent);

/// Writes `text` to `file` through a temporary beside it.
void write_whole(const std::filesystem::path& file, const std::string& text);

}  // namespace arcbid
