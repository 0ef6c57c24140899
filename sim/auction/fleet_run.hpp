// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/arcs/mission.hpp"
#include "core/auction/no_bidders.hpp"
#include "core/trades/exchanges.hpp"
#include "sim/auction/rounds.hpp"

namespace arcbid {

/// A stretch of an arc as it is flown; from_m > to_m: backwards.
struct FlownPiece {
  std::uint32_t arc = 0;
  double from_m = 0, to_m = 0;
};

/// What a fleet makes of a mission's arcs: auction, exchanges, everybody's own tour.
struct FleetRun {
  bool converged = false, agreed = false;
  std::size_t tasks = 0, unassigned = 0;
  std::vector<NoBidder> left;                   ///< what makes up `unassigned`, and why
  double piece_m = 0;                           ///< what arcs were cut into
  std::vector<std::vector<FlownPiece>> routes;  ///< by member
  std::vector<std::size_t> flown_tasks;         ///< by member, of `tasks`
  std::vector<double> times_s;                  ///< home to home
  double total_length_m = 0;
  std::uint64_t exchanges = 0;  ///< tried out on the way, also if undone later
  double auction_cpu_s = 0;     ///< of the whole fleet
  double trades_cpu_s = 0;      ///< of one agent: each works out all of it
  double tours_cpu_s = 0;       ///< of the whole fleet
};

/// Runs it in this thread, with straight legs and without loss, as `mission.auction` says.
FleetRun run_fleet(const Mission& mission, Graph graph, TradesKind trades);

/// One JSON object: makespan_s, total_length_m, uniformity (eq. 18) on pieces and on flight times,
/// no_bidders, cv_time (their standard deviation over their mean), exchanges, cpu_s, routes.
std::string to_json(const FleetRun& run);

}  // namespace arcbid
