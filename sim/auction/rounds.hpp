// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/arcs/mission.hpp"
#include "core/auction/score.hpp"
#include "sim/auction/instance.hpp"

namespace arcbid {

enum class Graph : std::uint8_t { complete, ring, line, star };

/// Neighbours of every agent (positions in the fleet, ascending). Star: the first is the centre.
std::vector<std::vector<std::size_t>> neighbours(Graph graph, std::size_t agents);
std::size_t diameter(Graph graph, std::size_t agents);

/// What an auction in synchronous rounds came to.
struct RoundsOutcome {
  std::vector<std::vector<TaskId>> paths;    ///< p_i, in flying order
  std::vector<std::vector<PathStop>> stops;  ///< the same with directions
  std::size_t last_change_round = 0;         ///< the last one in which anybody's mind changed
  std::size_t proof_round = 0;               ///< when the last agent had a proof; 0: no such thing
  bool converged = false;                    ///< quiet for 2 D + 2 rounds; else it was cut off
  bool agreed = false;                       ///< all believe the same winners and bids
  std::uint64_t messages = 0;  ///< sender to neighbour, until the last change (or proof)
  std::uint64_t sends = 0;     ///< the same, one send reaching all neighbours
  std::uint64_t bytes = 0;     ///< of these sends: whole tables or statements, and what is held
  std::uint64_t difference_bytes = 0;  ///< of the same where links lose nothing: only what is new
  std::uint64_t order_bytes = 0;       ///< and without bids; claims with Encoding::orders, else 0
};

/// How statements travel: with their bids; or also, to count the bytes, as the order of their tasks
/// from which the bids are recomputed, which costs CPU.
enum class Encoding : std::uint8_t { bids, orders };

/// Rounds after which a run that will not rest is cut off: thrice the bound N_min D that holds
/// under diminishing gains (Choi, Brunet, How 2009), and some.
std::size_t round_limit(const Instance& instance, Graph graph, std::uint32_t bundle_limit);

/// Runs all agents in this thread, without loss: in every round all decide, then all hear their
/// neighbours.
RoundsOutcome run_rounds(const Instance& instance, const AuctionSettings& settings, Graph graph,
                         Encoding encoding = Encoding::bids);

}  // namespace arcbid
