// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/auction/fleet_run.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/io/process/process.hpp"
#include "core/route/exchanged.hpp"
#include "core/route/route.hpp"
#include "sim/auction/protocol.hpp"
#include "sim/auction/spread.hpp"

namespace arcbid {
namespace {

/// CPU time of this thread, seconds, since the last time it was asked.
class Stopwatch {
 public:
  double lap_s() {
    const double now_s = thread_cpu_s();
    return now_s - std::exchange(last_s_, now_s);
  }

 private:
  double last_s_ = 0;
};

std::vector<NoBidder> left_over(const Mission& mission, const TaskSet& set,
                                const RoundsOutcome& won, const Transit& transit) {
  std::vector<Winnings> members;
  for (std::size_t i = 0; i < mission.fleet.size(); ++i)
    members.push_back({mission.fleet[i], won.paths[i], won.stops[i]});
  return no_bidders(members, set, mission.auction, transit);
}

}  // namespace

FleetRun run_fleet(const Mission& mission, Graph graph, TradesKind trades) {
  Stopwatch watch;
  watch.lap_s();
  const Instance instance{mission.fleet,
                          split(mission.arcs, mission.auction.split_m, mission.auction.max_tasks)};
  const RoundsOutcome won = run_rounds(instance, mission.auction, graph);
  FleetRun run;
  run.converged = won.converged;
  run.agreed = won.agreed;
  run.tasks = run.unassigned = instance.tasks.tasks.size();
  run.piece_m = instance.tasks.piece_m;
  for (const auto& path : won.stops) run.unassigned -= path.size();
  run.auction_cpu_s = watch.lap_s();
  const StraightTransit transit;
  if (run.unassigned > 0) run.left = left_over(mission, instance.tasks, won, transit);
  Mission as_told = mission;
  as_told.auction.trades = trades;
  const FleetPaths after = exchanged(as_told, mission.fleet, instance.tasks, won.stops, transit);
  run.exchanges = after.exchanges;
  run.trades_cpu_s = watch.lap_s();
  for (std::size_t i = 0; i < mission.fleet.size(); ++i) {
    const Route route =
        plan_route(mission, instance.tasks, after.paths[i], mission.fleet[i], transit);
    run.flown_tasks.push_back(after.paths[i].size());
    run.times_s.push_back(route.time_s);
    run.total_length_m += route.length_m;
    auto& flown = run.routes.emplace_back();
    for (const RouteLeg& leg : route.legs)
      if (leg.arc) flown.push_back({leg.arc->value, leg.from_m, leg.to_m});
  }
  run.tours_cpu_s = watch.lap_s();
  return run;
}

std::string to_json(const FleetRun& run) {
  nlohmann::json routes = nlohmann::json::array();
  std::vector<double> counts;
  for (const auto& pieces : run.routes) {
    nlohmann::json route = nlohmann::json::array();
    for (const FlownPiece& piece : pieces) route.push_back({piece.arc, piece.from_m, piece.to_m});
    routes.push_back(route);
    counts.push_back(static_cast<double>(pieces.size()));
  }
  nlohmann::json left = nlohmann::json::array();
  for (const NoBidder& one : run.left) left.push_back(to_text(one));
  const double fleet = static_cast<double>(run.routes.size());
  return nlohmann::json{
      {"makespan_s", *std::max_element(run.times_s.begin(), run.times_s.end())},
      {"total_length_m", run.total_length_m},
      {"uniformity", {{"count", uniformity(counts)}, {"time", uniformity(run.times_s)}}},
      {"cv_time", variation(run.times_s)},
      {"exchanges", run.exchanges},
      {"cpu_s", run.auction_cpu_s + run.trades_cpu_s + run.tours_cpu_s},
      {"cpu",
       {{"auction_fleet_s", run.auction_cpu_s},
        {"trades_agent_s", run.trades_cpu_s},
        {"tours_fleet_s", run.tours_cpu_s},
        {"fleet_s", run.auction_cpu_s + fleet * run.trades_cpu_s + run.tours_cpu_s}}},
      {"tasks", run.tasks},
      {"unassigned", run.unassigned},
      {"no_bidders", left},
      {"converged", run.converged},
      {"agreed", run.agreed},
      {"times_s", run.times_s},
      {"routes", routes}}
      .dump();
}

}  // namespace arcbid
