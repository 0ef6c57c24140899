// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/auction/agent.hpp"
#include "core/faults/link_model.hpp"
#include "sim/world/checkers/step.hpp"
#include "sim/world/spec.hpp"

namespace arcbid {

/// What became of one world.
struct WorldResult {
  std::uint64_t seed = 0;
  bool agreed = false;
  std::uint32_t rounds = 0;      ///< decisions of the agent that made most, until the agreement
  std::uint64_t steps = 0;       ///< of all agents
  std::uint64_t most_steps = 0;  ///< more are not taken (docs/SIMULATOR.md)
  std::uint64_t messages = 0, bytes = 0;
  std::uint64_t refused = 0;    ///< messages that were refused, as they had to be
  TimeNs agreed_ns = 0;         ///< when the last one of the final agreement proved it
  TimeNs calm_ns = 0;           ///< when the last fault, and what it had delayed, was over
  TimeNs bound_ns = 0;          ///< agreement must come so long after that
  double makespan_s = 0;        ///< the slowest agent's closed path
  double total_length_m = 0;    ///< of all closed paths
  std::vector<Belief> winners;  ///< of the agreement, an entry for each task; of the largest part
                                ///< of a fleet that ended in several
  std::uint64_t digest = 0;     ///< of all that happened, step by step
  std::vector<Violation> violations;
};

/// A line for everything that happens: `--trace`.
using Trace = std::function<void(const std::string&)>;

/// Hears all that the cores of a world consume and produce, in order. `life`: births, counted.
class WorldObserver {
 public:
  virtual ~WorldObserver() = default;
  /// `clock_ns`: what the agent's own clock shows.
  virtual void born(std::uint32_t life, AgentId agent, std::uint64_t incarnation, TimeNs now_ns,
                    TimeNs clock_ns) = 0;
  virtual void stepped(std::uint32_t life, TimeNs now_ns, const Event& event,
                       const Update& update) = 0;
  /// What the faults of links did to a message that was sent to this life at `now_ns`. Not told of
  /// one that nothing was done to.
  virtual void met_fate(std::uint32_t life, TimeNs now_ns, const Header& header,
                        const Fate& fate) = 0;
  /// It is there at the end of the world.
  virtual void outlived(std::uint32_t life, TimeNs now_ns) = 0;
};

/// Runs the world until all living agents hold a proof of one and the same agreement and nothing is
/// to come, or until the bound has passed, or it has taken more steps than any sound world. Two
/// phases: faults on, whatever they do; then calm, and agreement within the bound
/// (docs/SIMULATOR.md). Throws nothing; violations are in the result.
WorldResult run_world(const WorldSpec& spec, const Trace& trace = {},
                      WorldObserver* observer = nullptr);

}  // namespace arcbid
