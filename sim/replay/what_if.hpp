// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/world/live_run.hpp"
#include "sim/world/run.hpp"

namespace arcbid {

/// Other rules for a run that was. What is not set stays as it was.
struct OtherRules {
  std::optional<PolicyKind> policy;
  std::optional<ScoreKind> score;
  std::optional<std::uint32_t> agents;        ///< the first ones of the fleet only
  std::vector<AgentId> without;               ///< these were never there
  std::optional<std::uint32_t> bundle_limit;  ///< L_t
  std::optional<double> loss;                 ///< on every link, besides the run's own faults

  bool none() const;
};

/// Throws InputError when that leaves nobody, or names somebody who is not of the fleet.
WorldSpec under(const OtherRules& rules, WorldSpec world);

/// The world without the last crash of `agent` before `declared_ns`; none: nothing on record is a
/// crash of it, so that it was missed for another reason.
std::optional<WorldSpec> with_alive(WorldSpec world, AgentId agent, TimeNs declared_ns);

/// How many tasks have another winner.
std::size_t owners_changed(const WorldResult& a, const WorldResult& b);

}  // namespace arcbid
