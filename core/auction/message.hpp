// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/arcs/arc.hpp"
#include "core/base/ids.hpp"

namespace arcbid {

/// Which of two statements of one agent is newer: compared field by field, in this order. A
/// tombstone (dead) of a life beats everything said in that life; a new incarnation beats the
/// tombstone.
struct StatementKey {
  std::uint64_t incarnation =
      0;  ///< from the clock at birth, so that no two lives share one; 0: never heard
  bool dead = false;
  std::uint32_t version = 0;
  friend auto operator<=>(const StatementKey&, const StatementKey&) = default;
};

/// "I take this task at this bid": one entry of bundle b_i, in bundle order.
struct Claim {
  TaskId task;
  double bid = 0;
  friend bool operator==(const Claim&, const Claim&) = default;
};

/// What an agent states under the claims policy: its whole bundle.
struct Claims {
  std::vector<Claim> bundle;
  friend bool operator==(const Claims&, const Claims&) = default;
};

/// One row of an agent's table under published CBBA: z_i[j] and y_i[j].
struct Belief {
  std::optional<AgentId> winner;
  double bid = 0;
  friend bool operator==(const Belief&, const Belief&) = default;
};

/// What an agent states under CBBA: z_i, y_i (index = task), and s_i (index = roster position), or
/// under ACBBA t_i (index = task).
struct Table {
  std::vector<Belief> beliefs;
  std::vector<std::uint64_t> timestamps;
  friend bool operator==(const Table&, const Table&) = default;
};

using StatementBody = std::variant<Claims, Table>;

/// The newest thing an agent said about its own bundle. Whole: applying it twice, late, or after a
/// newer one changes nothing.
struct Statement {
  AgentId agent;
  StatementKey key;
  StatementBody body;
};

/// In front of every message between agents.
struct Header {
  AgentId sender;
  std::uint64_t incarnation = 0;     ///< the sender's life
  std::uint64_t sequence = 0;        ///< grows by one with every message of that life
  std::uint64_t mission_digest = 0;  ///< 0: the sender has no mission yet
  std::uint64_t task_digest = 0;     ///< digest of the split task set T (SC-CBBA step 1)
};

/// The sender's own statement. Best effort by default: losing one costs time, never correctness.
struct BidMessage {
  Header header;
  Statement statement;
};

/// Somebody else's statement, passed on to whoever lacks it: DDS does not forward.
struct RelayMessage {
  Header header;
  Statement statement;
};

enum class Phase : std::uint8_t { waiting_for_mission, waiting_for_peers, auction, agreed, routed };

/// Proof of life that can be relayed: "I heard, directly or not, heartbeat `counter` of this life".
struct Heartbeat {
  std::uint64_t incarnation = 0;
  std::uint64_t counter = 0;
  friend auto operator<=>(const Heartbeat&, const Heartbeat&) = default;
};

/// What an agent holds of another.
struct Held {
  AgentId agent;
  StatementKey key;
  friend bool operator==(const Held&, const Held&) = default;
};

/// The latest heartbeat that an agent knows of another.
struct Pulse {
  AgentId agent;
  Heartbeat heartbeat;
  friend bool operator==(const Pulse&, const Pulse&) = default;
};

/// Status and readiness (spec: "agreement is proven, not timed").
struct StatusMessage {
  Header header;
  Phase phase = Phase::waiting_for_mission;
  std::uint32_t round = 0;          ///< decisions the sender has made
  std::uint32_t matched_peers = 0;  ///< other agents whose endpoints the sender's DDS has matched
  std::uint64_t view_hash = 0;      ///< H: hash of the map V of newest statements
  std::vector<AgentId> ready;       ///< S: agents known to have been ready for exactly V
  /// Whether `view` and `heartbeats` name the whole roster. Else only what is new since the
  /// sender's last whole status: keys, and lives that were not known then. Neither names anybody
  /// before the mission.
  bool whole = true;
  std::vector<Held> view;         ///< V's keys, ascending agents
  std::vector<Pulse> heartbeats;  ///< ascending agents
};

/// A stretch of a route: a transit, or (part of) an arc flown from from_m to to_m (from_m > to_m:
/// backwards).
struct RouteLeg {
  std::optional<ArcId> arc;  ///< none: transit
  double from_m = 0, to_m = 0;
  std::vector<Waypoint> waypoints;
};

/// A route, home to home, for the allocation proven under `view_hash`. A newer agreement voids it.
struct RouteMessage {
  Header header;
  std::uint64_t view_hash = 0;
  std::uint64_t owners_digest = 0;  ///< who flies what, after exchanges: the same for every member
  double length_m = 0;
  double time_s = 0;
  std::vector<RouteLeg> legs;
};

enum class Command : std::uint8_t { complete, abort };

/// From the coordinator to all agents.
struct ControlMessage {
  std::uint64_t mission_digest = 0;
  Command command = Command::complete;
  std::string reason;
};

}  // namespace arcbid
