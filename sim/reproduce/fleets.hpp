// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "core/arcs/mission.hpp"
#include "core/auction/task_set.hpp"
#include "core/structure/bridge_arcs.hpp"
#include "sim/auction/fleet_run.hpp"
#include "sim/reproduce/experiment.hpp"

namespace arcbid::reproduce {

/// How a fleet divides arcs and orders them.
struct Method {
  std::string_view name;
  PolicyKind policy = PolicyKind::cbba;
  ScoreKind score = ScoreKind::minimax;
  bool splits = true;                            ///< false: arcs are auctioned whole
  std::optional<double> piece_m = std::nullopt;  ///< none: the shortest arc, eq. 4
  bool is_limited = false;  ///< no UAV takes more than its share of tasks, rounded up
  TradesKind trades = TradesKind::off;
  TourSolver solver = TourSolver::crsom;
};

inline constexpr Method kCbba{.name = "CBBA", .splits = false};
inline constexpr Method kScCbba{.name = "SC-CBBA"};
inline constexpr Method kOurs{.name = "ours",
                              .policy = PolicyKind::claims,
                              .score = ScoreKind::minimax_long_first,
                              .piece_m = 10,
                              .trades = TradesKind::full,
                              .solver = TourSolver::crsom_ls};

/// The paper's arcs, slices and rows, of the bridge with D = 5 m, and what it took to make them.
struct BridgeArcs {
  std::vector<Arc> arcs;
  Vec3 low_m, high_m;  ///< bounding box of the bridge
  double cpu_s = 0;
};
BridgeArcs make_arcs(const Settings& settings, RowSide rows, std::uint64_t seed);

/// N UAVs at 1 m/s, on the ground beside the bridge, as missions place them.
std::vector<Uav> fleet_of(std::uint32_t agents, const BridgeArcs& bridge);

/// Straight legs, no loss, everybody hears everybody.
FleetRun divide(const BridgeArcs& bridge, std::uint32_t agents, const Method& method,
                std::uint64_t seed);

/// Metres of arcs that each UAV flies.
std::vector<double> metres_of_arcs(const FleetRun& run);

/// Of `pieces`, which the same arcs were cut into, how many each UAV flies; what it flies of one in
/// part counts in part.
std::vector<double> pieces_flown(const FleetRun& run, const TaskSet& pieces);

/// A panel in which each UAV has a colour, and its home a dot. `with_legs`: what is between arcs,
/// too.
Panel routes_panel(const BridgeArcs& bridge, std::uint32_t agents, const FleetRun& run,
                   bool with_legs);

}  // namespace arcbid::reproduce
