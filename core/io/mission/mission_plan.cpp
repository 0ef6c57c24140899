// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/mission/mission_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/auction/task_set.hpp"
#include "core/base/error.hpp"
#include "core/coverage/coverage_arcs.hpp"
#include "core/io/structure_reader.hpp"

namespace arcbid {
namespace {

StructureInput structure_of(const StructureConfig& config) {
  if (config.file) return read_structure(*config.file, {.unit = config.unit, .up = config.up});
  return {generate(config.parametric), {}};
}

void append(std::vector<std::string>& all, std::vector<std::string> more) {
  std::move(more.begin(), more.end(), std::back_inserter(all));
}

/// What the reader noticed often explains what the planner cannot do: wrong units above all.
ArcPlan arcs_of(const StructureInput& input, const Config& config) {
  try {
    return coverage_arcs(input.structure, config.coverage);
  } catch (const InputError& error) {
    std::string lines;
    for (const std::string& warning : input.warnings) lines += warning + "\n";
    const std::string file = config.structure.file ? config.structure.file->string() + ": " : "";
    throw InputError(lines + file + error.what());
  }
}

/// A mesh that is small enough stays one; of anything larger, points at equal steps.
Structure thinned(const Structure& structure) {
  constexpr std::size_t most = 200'000;
  if (structure.points.size() <= most && structure.triangles.size() <= most) return structure;
  Structure out;
  const std::size_t step = (structure.points.size() + most - 1) / most;
  for (std::size_t p = 0; p < structure.points.size(); p += step)
    out.points.push_back(structure.points[p]);
  return out;
}

/// Everybody splits the arcs alike, so it is known beforehand whether the bundles can hold them.
void require_room(const Mission& mission) {
  const std::size_t limit = mission.auction.bundle_limit, agents = mission.fleet.size();
  if (limit == 0) return;
  const std::size_t tasks =
      split(mission.arcs, mission.auction.split_m, mission.auction.max_tasks).tasks.size();
  if (limit * agents < tasks)
    throw InputError(fmt::format(
        "auction.bundle_limit: {} for each of {} agents leaves {} of {} tasks without an "
        "owner; legal are 0 (no limit) or at least {}",
        limit, agents, tasks - limit * agents, tasks, (tasks + agents - 1) / agents));
}

}  // namespace

std::vector<Uav> place_fleet(const FleetConfig& fleet, const Vec3& low_m, const Vec3& high_m,
                             double clear_m) {
  if (!fleet.uavs.empty()) {
    std::vector<Uav> uavs = fleet.uavs;
    std::sort(uavs.begin(), uavs.end(), [](const Uav& a, const Uav& b) { return a.id < b.id; });
    return uavs;
  }
  const Vec3 size_m = high_m - low_m;
  const int along = size_m.x() >= size_m.y() ? 0 : 1, across = 1 - along;
  std::vector<Uav> uavs;
  for (std::uint32_t i = 0; i < fleet.agents; ++i) {
    Vec3 home = low_m;
    home[along] += (i + 0.5) / fleet.agents * size_m[along];
    home[across] -= clear_m;
    uavs.push_back({{i + 1}, home, fleet.speed_mps});
  }
  return uavs;
}

MissionPlan plan_mission(const Config& config, std::uint64_t id) {
  StructureInput input = structure_of(config.structure);
  ArcPlan arcs = arcs_of(input, config);
  MissionPlan plan;
  plan.shown = thinned(input.structure);
  plan.warnings = std::move(input.warnings);
  append(plan.warnings, std::move(arcs.warnings));
  plan.mission = {
      .id = id,
      .name = config.name,
      .arcs = std::move(arcs.arcs),
      .fleet = place_fleet(config.fleet, arcs.low_m, arcs.high_m, 2 * config.coverage.standoff_m),
      .auction = config.auction,
      .tour = config.tour};
  require_room(plan.mission);
  return plan;
}

}  // namespace arcbid
