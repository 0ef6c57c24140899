// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/certificate/parallel.hpp"
#include "sim/reproduce/fleets.hpp"
#include "sim/reproduce/models.hpp"

namespace arcbid::reproduce {
namespace {

constexpr std::array kMethods{kScCbba, kOurs};

/// CPU seconds from the bridge to all routes, each part of it done once.
double planning_s(const BridgeArcs& bridge, const FleetRun& run) {
  return bridge.cpu_s + run.auction_cpu_s + run.trades_cpu_s + run.tours_cpu_s;
}

double slowest_s(const FleetRun& run) {
  return *std::ranges::max_element(run.times_s);
}

/// Between the two values that are next to it. `sorted` is not empty.
double quantile(const std::vector<double>& sorted, double share) {
  const double at = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (at - std::floor(at)) * (sorted[above] - sorted[below]);
}

struct Repeats {
  std::vector<double> mission_s, planned_s;
};

Repeats repeat(const std::vector<BridgeArcs>& bridges, std::uint32_t agents, const Method& method,
               const Settings& settings) {
  Repeats out{std::vector<double>(bridges.size()), std::vector<double>(bridges.size())};
  certificate::in_chunks(bridges.size(), 1, settings.jobs, [&](std::size_t r, std::size_t) {
    const FleetRun run = divide(bridges[r], agents, method, settings.seed + r);
    out.mission_s[r] = slowest_s(run);
    out.planned_s[r] = planning_s(bridges[r], run);
  });
  std::ranges::sort(out.mission_s);
  return out;
}

std::vector<Cell> row_of(std::uint32_t agents, const Method& method, const Repeats& repeats) {
  double planned_s = 0;
  for (const double one_s : repeats.planned_s)
    planned_s += one_s / static_cast<double>(repeats.planned_s.size());
  const double low_s = quantile(repeats.mission_s, 0.25),
               high_s = quantile(repeats.mission_s, 0.75);
  return {static_cast<double>(agents),
          std::string(method.name),
          quantile(repeats.mission_s, 0.5),
          low_s,
          high_s,
          high_s - low_s,
          planned_s};
}

/// Medians as a line, quartiles as bars.
Panel times_panel(const Table& table) {
  Panel panel{"", "UAVs N", "mission time (s)", {}};
  for (const Method& method : kMethods) {
    const int colour = static_cast<int>(panel.series.size() / 2);
    Series medians{std::string(method.name), {{}}, true, true, colour};
    Series bars{"", {}, true, false, colour};
    for (const auto& row : table.rows) {
      if (std::get<std::string>(row[1]) != method.name) continue;
      const double n = std::get<double>(row[0]);
      medians.strokes[0].push_back({n, std::get<double>(row[2])});
      bars.strokes.push_back({{n, std::get<double>(row[3])}, {n, std::get<double>(row[4])}});
    }
    panel.series.push_back(std::move(medians));
    panel.series.push_back(std::move(bars));
  }
  return panel;
}

constexpr const char* kPlace =
    " Slices and rows, D = 5 m, straight legs, UAVs at 1 m/s, on the ground along the bridge.";
constexpr const char* kSeconds =
    "The paper's planning takes 29.019 s on average over N = 3 to 6, in MATLAB on another machine; "
    "ours is CPU seconds, from the bridge to all routes, each part done once (in a fleet every UAV "
    "works out the exchanges by itself, at the same time).";

}  // namespace

Finding fig10(const Settings& settings) {
  Finding out{.name = "fig10",
              .title = "Fig. 10: routes, and how long it takes to plan them",
              .setting = bridge_text(settings.bridge) + kPlace,
              .table = {{{"agents", "N", 0},
                         {"method", "method", 0},
                         {"arcs_cpu_s", "arcs (CPU s)", 3},
                         {"auction_cpu_s", "auction", 3},
                         {"exchanges_cpu_s", "exchanges", 3},
                         {"tours_cpu_s", "tours", 3},
                         {"planned_cpu_s", "all (CPU s)", 3},
                         {"paper_mean_s", "paper, mean of N = 3 to 6 (s)", 3},
                         {"mission_s", "mission (s)", 1},
                         {"length_m", "all UAVs (m)", 0}},
                        {}},
              .pictures = {{"fig10", "Routes of SC-CBBA and CRSOM", 1, {}}},
              .differences = {kSeconds,
                              "Legs are straight, as in eq. 2, and may lead through the bridge; "
                              "`arcbid plan` and `arcbid run` fly around it."}};
  const BridgeArcs bridge = make_arcs(settings, RowSide::short_side, settings.seed);
  for (std::uint32_t agents = 3; agents <= 6; ++agents) {
    settings.tell(fmt::format("fig10: N = {}", agents));
    for (const Method& method : kMethods) {
      const FleetRun run = divide(bridge, agents, method, settings.seed);
      out.table.rows.push_back({static_cast<double>(agents), std::string(method.name), bridge.cpu_s,
                                run.auction_cpu_s, run.trades_cpu_s, run.tours_cpu_s,
                                planning_s(bridge, run), paper::kPlanningS, slowest_s(run),
                                run.total_length_m});
      if (method.name == kScCbba.name)
        out.pictures[0].panels.push_back(routes_panel(bridge, agents, run, true));
    }
  }
  return out;
}

Finding fig11(const Settings& settings) {
  Finding out{.name = "fig11",
              .title = "Fig. 11: mission time by the number of UAVs",
              .setting = fmt::format("{}{} {} repeats, each with other samples of the surface and "
                                     "another seed.",
                                     bridge_text(settings.bridge), kPlace, settings.repeats),
              .table = {{{"agents", "N", 0},
                         {"method", "method", 0},
                         {"mission_median_s", "mission, median (s)", 1},
                         {"mission_lower_quartile_s", "lower quartile", 1},
                         {"mission_upper_quartile_s", "upper quartile", 1},
                         {"mission_iqr_s", "IQR", 1},
                         {"planned_cpu_s", "planned in, mean (CPU s)", 2}},
                        {}},
              .pictures = {},
              .differences = {
                  "The paper prints no numbers here, and its bridge is another one: only the shape "
                  "can be compared. More UAVs, less time: but for the way out and home, by 1/N.",
                  kSeconds}};
  std::vector<BridgeArcs> bridges(settings.repeats);
  settings.tell(fmt::format("fig11: arcs, {} times", settings.repeats));
  certificate::in_chunks(bridges.size(), 1, settings.jobs, [&](std::size_t r, std::size_t) {
    bridges[r] = make_arcs(settings, RowSide::short_side, settings.seed + r);
  });
  for (std::uint32_t agents = 2; agents <= 7; ++agents) {
    settings.tell(fmt::format("fig11: N = {}", agents));
    for (const Method& method : kMethods)
      out.table.rows.push_back(row_of(agents, method, repeat(bridges, agents, method, settings)));
  }
  out.pictures = {
      {"fig11", "Median of the mission's time, and its quartiles", 1, {times_panel(out.table)}}};
  return out;
}

}  // namespace arcbid::reproduce
