// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "sim/world/run.hpp"

namespace arcbid {

/// One world and what its faults cost.
struct PricedResult {
  WorldResult world;
  std::optional<WorldResult> fault_free;  ///< the same world, and nothing goes wrong
};

/// A world for every seed; `make` may be called by several threads at once.
struct Worlds {
  std::function<WorldSpec(std::uint64_t seed)> make;
  bool price = true;  ///< run every world without its faults too
};
Worlds worlds_of(const WorldSettings& settings);

/// Runs the worlds of seeds `first` to `last`, both included, on `jobs` threads. `take` gets the
/// results one at a time in the order of the seeds, whatever the number of threads; when it returns
/// false the batch stops.
void run_batch(const Worlds& worlds, std::uint64_t first, std::uint64_t last, unsigned jobs,
               const std::function<bool(const PricedResult&)>& take);

/// The world of one seed, and its price when that is asked for.
PricedResult run_priced(const Worlds& worlds, std::uint64_t seed);

}  // namespace arcbid
