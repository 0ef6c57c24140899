// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/mission/mission_plan.hpp"

#include <algorithm>
#include <utility>

#include "core/io/structure_reader.hpp"

namespace arcbid {
namespace {

StructureInput structure_of(const StructureConfig& config) {
  if (config.file)
    return read_structure(*config.file, {.unit = config.unit, .up = config.up});
  return {generate(config.parametric), {}};
}

void append(std::vector<std::string>& all, std::vector<std::string> more) {
  std::move(more.begin(), more.end(), std::back_inserter(all));
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
  ArcPlan arcs = bridge_arcs(input.structure, config.coverage);
  MissionPlan plan;
  plan.warnings = std::move(input.warnings);
  append(plan.warnings, std::move(arcs.warnings));
  plan.mission = {.id = id,
                  .name = config.name,
                  .arcs = std::move(arcs.arcs),
                  .fleet = place_fleet(config.fleet, arcs.low_m, arcs.high_m,
                                       2 * config.coverage.standoff_m),
                  .auction = config.auction,
                  .tour = config.tour};
  return plan;
}

}  // namespace arcbid
