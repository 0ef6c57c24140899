// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/reproduce/fleets.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "core/io/mission/mission_plan.hpp"
#include "core/io/process/process.hpp"
#include "sim/reproduce/models.hpp"

namespace arcbid::reproduce {
namespace {

constexpr double kWholeM = 1e9;

std::vector<Waypoint> stretch(const Arc& arc, const FlownPiece& piece) {
  auto line =
      part(arc.waypoints, std::min(piece.from_m, piece.to_m), std::max(piece.from_m, piece.to_m));
  return piece.from_m < piece.to_m ? line : reversed(std::move(line));
}

}  // namespace

BridgeArcs make_arcs(const Settings& settings, RowSide rows, std::uint64_t seed) {
  const double start_s = thread_cpu_s();
  CoverageSettings coverage = coverage_settings(settings, paper::kModelling.back().spacing_m);
  coverage.rows = rows;
  coverage.seed = seed;
  ArcPlan plan = bridge_arcs(generate(settings.bridge), coverage);
  return {std::move(plan.arcs), plan.low_m, plan.high_m, thread_cpu_s() - start_s};
}

std::vector<Uav> fleet_of(std::uint32_t agents, const BridgeArcs& bridge) {
  FleetConfig fleet;
  fleet.agents = agents;
  return place_fleet(fleet, bridge.low_m, bridge.high_m, 2 * CoverageSettings{}.standoff_m);
}

FleetRun divide(const BridgeArcs& bridge, std::uint32_t agents, const Method& method,
                std::uint64_t seed) {
  Mission mission;
  mission.arcs = bridge.arcs;
  mission.fleet = fleet_of(agents, bridge);
  mission.auction.policy = method.policy;
  mission.auction.score = method.score;
  mission.auction.split_m = method.splits ? method.piece_m : kWholeM;
  mission.tour.solver = method.solver;
  mission.tour.seed = seed;
  if (method.is_limited) {
    const auto tasks = static_cast<std::uint32_t>(
        split(mission.arcs, mission.auction.split_m, mission.auction.max_tasks).tasks.size());
    mission.auction.bundle_limit = (tasks + agents - 1) / agents;
  }
  return run_fleet(mission, Graph::complete, method.trades);
}

std::vector<double> metres_of_arcs(const FleetRun& run) {
  std::vector<double> metres;
  for (const auto& route : run.routes) {
    double sum_m = 0;
    for (const FlownPiece& piece : route) sum_m += std::abs(piece.to_m - piece.from_m);
    metres.push_back(sum_m);
  }
  return metres;
}

std::vector<double> pieces_flown(const FleetRun& run, const TaskSet& pieces) {
  std::vector<double> out(run.routes.size());
  for (std::size_t u = 0; u < out.size(); ++u)
    for (const FlownPiece& flown : run.routes[u])
      for (const Task& piece : pieces.tasks) {
        if (piece.arc.value != flown.arc) continue;
        const double first_m = std::max(piece.from_m, std::min(flown.from_m, flown.to_m));
        const double last_m = std::min(piece.to_m, std::max(flown.from_m, flown.to_m));
        out[u] += std::max(0.0, last_m - first_m) / piece.length_m();
      }
  return out;
}

Panel routes_panel(const BridgeArcs& bridge, std::uint32_t agents, const FleetRun& run,
                   bool with_legs) {
  Panel panel{fmt::format("N = {}", agents), "", "", {}};
  const std::vector<Uav> fleet = fleet_of(agents, bridge);
  for (std::size_t u = 0; u < fleet.size(); ++u) {
    const int colour = static_cast<int>(u);
    Series lines{fmt::format("UAV {}", u + 1), {}, true, false, colour};
    const PlotPoint home = projected(fleet[u].home_m);
    std::vector<PlotPoint> way{home};
    for (const FlownPiece& piece : run.routes[u]) {
      const auto arc = projected(stretch(bridge.arcs[piece.arc], piece));
      way.insert(way.end(), arc.begin(), arc.end());
      if (!with_legs) lines.strokes.push_back(arc);
    }
    way.push_back(home);
    if (with_legs) lines.strokes.push_back(std::move(way));
    panel.series.push_back(std::move(lines));
    panel.series.push_back({"", {{home}}, false, true, colour});
  }
  return panel;
}

}  // namespace arcbid::reproduce
