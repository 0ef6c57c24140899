// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "sim/world/run.hpp"

namespace arcbid {

/// What makes a world: the parts that a shrinker may take away.
struct WorldSize {
  std::size_t faults = 0;  ///< of links, partitions and agents
  std::size_t agents = 0, arcs = 0;
  friend auto operator<=>(const WorldSize&, const WorldSize&) = default;
};
WorldSize size_of(const WorldSpec& spec);

/// Every world that is `spec` less one part: a fault, an agent, or an arc; at least one agent and
/// one arc stay.
std::vector<WorldSpec> smaller_worlds(const WorldSpec& spec);

/// Takes parts away, faults first, as long as `fails` says that the world still does; the result
/// fails, and no world that lacks one part more does. `fails` must hold for `spec`.
WorldSpec shrink(WorldSpec spec, const std::function<bool(const WorldSpec&)>& fails);

}  // namespace arcbid
