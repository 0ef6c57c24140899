// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/arcs/arc.hpp"
#include "core/base/ids.hpp"

namespace arcbid {

/// A stretch of time, [start, end), in nanoseconds since the launch (or the start of a world).
struct Window {
  TimeNs start_ns = 0;
  TimeNs end_ns = INT64_MAX;
  bool contains(TimeNs t) const { return start_ns <= t && t < end_ns; }
  friend bool operator==(const Window&, const Window&) = default;
};

/// Gilbert-Elliott loss: a two-state chain that moves by one step with every message. In the bad
/// state a message is lost with `bad_loss`, in the good one with `good_loss`.
struct Burst {
  double mean_loss = 0.3;  ///< share of messages lost in the long run
  double mean_length = 8;  ///< mean number of consecutive messages in the bad state, >= 1
  double good_loss = 0;    ///< loss in the good state
  double bad_loss = 1;     ///< loss in the bad state; > mean_loss
  friend bool operator==(const Burst&, const Burst&) = default;
};

/// How long a message takes. Each message has its own due time, so that delays reorder.
struct Delay {
  enum class Kind : std::uint8_t { fixed, uniform, exponential };
  Kind kind = Kind::fixed;
  TimeNs least_ns = 0;  ///< fixed: the delay; uniform: the lower end; exponential: the floor
  TimeNs most_ns = 0;   ///< uniform: the upper end
  TimeNs mean_ns = 0;   ///< exponential: mean above the floor
  friend bool operator==(const Delay&, const Delay&) = default;
};

/// A link that carries so much and no more: messages queue behind each other; what does not fit
/// into the queue is lost.
struct Capacity {
  double bytes_per_s = 0;         ///< > 0
  std::uint64_t queue_bytes = 0;  ///< 0: unbounded
  friend bool operator==(const Capacity&, const Capacity&) = default;
};

/// Loss that grows with the distance between the agents' places (their homes): none up to `full_m`,
/// all beyond `none_m`, linear between.
struct Reach {
  double full_m = 0, none_m = 0;
  friend bool operator==(const Reach&, const Reach&) = default;
};

/// An axis-aligned box that radio does not pass.
struct Obstacle {
  Vec3 least_m = Vec3::Zero(), most_m = Vec3::Zero();
  friend bool operator==(const Obstacle& a, const Obstacle& b) {
    return a.least_m == b.least_m && a.most_m == b.most_m;
  }
};

/// One fault of some directed links. Every fault that applies acts, one after another.
struct LinkFault {
  std::vector<AgentId> from, to;  ///< empty: any agent
  bool both_ways = false;         ///< also the links from `to` to `from`
  Window when;
  double loss = 0;         ///< independent, [0, 1]
  double loss_per_kb = 0;  ///< further loss for each 1000 bytes of the message
  std::optional<Burst> burst;
  std::optional<Reach> reach;
  std::vector<Obstacle> obstacles;  ///< nothing passes where the line of sight meets one
  std::optional<Delay> delay;
  double duplicate = 0;  ///< share of messages that come twice
  double stale = 0;      ///< share of messages that come again after `stale_ns`
  TimeNs stale_ns = 0;
  std::optional<Capacity> capacity;
  bool clog = false;   ///< held back until the window's end, then all at once
  bool cut = false;    ///< nothing passes
  TimeNs flap_ns = 0;  ///< > 0: `cut` holds in every other stretch this long
  friend bool operator==(const LinkFault&, const LinkFault&) = default;
};

/// Nothing crosses between different groups. Agents in no group are alone.
struct Partition {
  std::vector<std::vector<AgentId>> groups;
  Window when;
  TimeNs flap_ns = 0;  ///< > 0: holds in every other stretch this long
  friend bool operator==(const Partition&, const Partition&) = default;
};

enum class TopologyKind : std::uint8_t { complete, ring, line, star, geometric };

/// Which links exist at all, by position in the fleet; geometric: the agents' places are at most
/// `radius_m` apart.
struct Topology {
  TopologyKind kind = TopologyKind::complete;
  double radius_m = 0;
  friend bool operator==(const Topology&, const Topology&) = default;
};

enum class AgentFaultKind : std::uint8_t {
  crash,      ///< SIGKILL; comes back after `for_ns` when that is given
  pause,      ///< SIGSTOP for `for_ns`, then SIGCONT
  late,       ///< starts `for_ns` after the others (at_ns is not used)
  clock,      ///< its clock runs `offset_ns` off and drifts by `drift`, from at_ns on
  twin,       ///< a second process with the same id, for `for_ns`
  malformed,  ///< says what it must not, `count` times: see Malformation
};

enum class Malformation : std::uint8_t {
  nan_bid,
  unknown_task,
  unknown_agent,
  wrong_mission,
  wrong_tasks,
  over_bid,  ///< well formed but false: bids far above anybody's for every task, then silence
  replay,    ///< an old message of its own again
};

/// Their names in schedules and logs, in the order of the enumerators.
inline constexpr std::array<std::string_view, 7> malformation_names{
    "nan_bid",     "unknown_task", "unknown_agent", "wrong_mission",
    "wrong_tasks", "over_bid",     "replay"};
constexpr std::string_view name_of(Malformation malformation) {
  return malformation_names[static_cast<std::size_t>(malformation)];
}

/// One fault of one agent, or of the coordinator (agent 0: only crash and pause).
struct AgentFault {
  AgentId agent;
  AgentFaultKind kind = AgentFaultKind::crash;
  TimeNs at_ns = 0;
  std::optional<TimeNs> for_ns;  ///< none: for good
  TimeNs offset_ns = 0;          ///< clock
  double drift = 0;              ///< clock: seconds gained a second
  Malformation malformation = Malformation::nan_bid;
  std::uint32_t count = 1;  ///< malformed
  friend bool operator==(const AgentFault&, const AgentFault&) = default;
};

/// Everything that goes wrong in a run, on one timeline. The same schedule does the same to the
/// same messages.
struct FaultSchedule {
  std::string name;
  std::uint64_t seed = 1;
  /// All link faults and partitions end here; the topology stays. None: they go on.
  std::optional<TimeNs> until_ns;
  Topology topology;
  std::vector<LinkFault> links;
  std::vector<Partition> partitions;
  std::vector<AgentFault> agents;
  friend bool operator==(const FaultSchedule&, const FaultSchedule&) = default;
};

}  // namespace arcbid
