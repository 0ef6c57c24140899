// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/mission/mission_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/airspace/surroundings.hpp"
#include "core/auction/no_bidders.hpp"
#include "core/auction/task_set.hpp"
#include "core/base/error.hpp"
#include "core/coverage/coverage_arcs.hpp"
#include "core/io/structure_reader.hpp"
#include "core/route/make_transit.hpp"

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

/// Where in the config a UAV stands: fleets are sorted by id.
std::size_t given_at(const Config& config, const Uav& uav) {
  const auto& uavs = config.fleet.uavs;
  return static_cast<std::size_t>(
      std::find_if(uavs.begin(), uavs.end(), [&](const Uav& u) { return u.id == uav.id; }) -
      uavs.begin());
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

/// Default homes stand far enough away; a config may have put one under the deck.
void require_clear_homes(const Config& config, const std::vector<Uav>& fleet,
                         const Surroundings& surroundings, const Airspace& airspace) {
  for (std::size_t i = 0; i < fleet.size(); ++i) {
    const Vec3& home = fleet[i].home_m;
    if (surroundings.clear_home(home, airspace)) continue;
    const std::string place =
        config.fleet.uavs.empty()
            ? fmt::format("fleet: the home of agent {}", fleet[i].id.value)
            : fmt::format("fleet.uavs[{}].home_m", given_at(config, fleet[i]));
    throw InputError(fmt::format(
        "{}: from ({}, {}, {}) a UAV cannot rise to z = {:.6g} and fly on with coverage.safety_m "
        "{} "
        "between it and the structure; legal is a place with that and some {:.2g} m more around it",
        place, home.x(), home.y(), home.z(), surroundings.floor_m(), config.coverage.safety_m,
        airspace.cell_m));
  }
}

/// Default homes are on the ground; where the ground itself belongs to the surface, as much higher
/// as its clearance asks for.
void lift_homes(std::vector<Uav>& fleet, const Surroundings& surroundings,
                const Airspace& airspace) {
  constexpr double step_m = 0.25;
  for (Uav& uav : fleet)
    for (Vec3 home = uav.home_m; home.z() <= surroundings.floor_m(); home.z() += step_m) {
      if (!surroundings.clear_home(home, airspace)) continue;
      uav.home_m = home;
      break;
    }
}

/// What no UAV can fly though nothing else were to be flown: told before anybody bids. The legs of
/// a mission take a while to work out, and without limits nobody asks for them.
std::vector<std::string> beyond_everybody(const Mission& mission) {
  const auto has_limits = [](const Uav& uav) {
    return uav.endurance_s || uav.payload != Payload::any;
  };
  if (std::ranges::none_of(mission.fleet, has_limits)) return {};
  std::vector<Winnings> fleet;
  for (const Uav& uav : mission.fleet) fleet.push_back({.uav = uav, .taken = {}, .path = {}});
  AuctionSettings settings = mission.auction;
  settings.bundle_limit = 0;
  const TaskSet set = split(mission.arcs, settings.split_m, settings.max_tasks);
  std::vector<std::string> lines;
  for (const NoBidder& left : no_bidders(fleet, set, settings, *make_transit(mission)))
    if (left.why != NoBidderReason::endurance_left) lines.push_back(to_text(left));
  return lines;
}

/// The model of what is in the way, arcs that nobody could reach left out.
Airspace airspace_of(const Surroundings& surroundings, const Config& config, ArcPlan& arcs) {
  Airspace airspace = surroundings.airspace(arcs.arcs, arcs.warnings);
  if (arcs.arcs.empty())
    throw InputError(fmt::format(
        "structure: no arc can be reached from outside with coverage.safety_m {} all the way",
        config.coverage.safety_m));
  return airspace;
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
    uavs.push_back({{i + 1}, home, fleet.speed_mps, fleet.endurance_s, fleet.payload});
  }
  return uavs;
}

MissionPlan plan_mission(const Config& config, std::uint64_t id) {
  StructureInput input = structure_of(config.structure);
  ArcPlan arcs = arcs_of(input, config);
  const Surroundings surroundings(input.structure, config.coverage);
  Airspace airspace = airspace_of(surroundings, config, arcs);
  Vec3 ground_m = arcs.low_m;
  ground_m.z() = config.coverage.ground_m.value_or(ground_m.z());
  MissionPlan plan;
  plan.shown = thinned(input.structure);
  plan.warnings = std::move(input.warnings);
  append(plan.warnings, std::move(arcs.warnings));
  plan.mission = {
      .id = id,
      .name = config.name,
      .arcs = std::move(arcs.arcs),
      .fleet = place_fleet(config.fleet, ground_m, arcs.high_m, 2 * config.coverage.standoff_m),
      .airspace = std::move(airspace),
      .auction = config.auction,
      .tour = config.tour};
  const bool is_camera = config.coverage.sensor.kind == SensorKind::camera;
  for (Arc& arc : plan.mission.arcs) arc.payload = is_camera ? Payload::camera : Payload::lidar;
  if (config.fleet.uavs.empty())
    lift_homes(plan.mission.fleet, surroundings, plan.mission.airspace);
  require_clear_homes(config, plan.mission.fleet, surroundings, plan.mission.airspace);
  require_room(plan.mission);
  append(plan.warnings, beyond_everybody(plan.mission));
  return plan;
}

}  // namespace arcbid
