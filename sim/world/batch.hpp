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

/// Runs the worlds of seeds `first` to `last`, both included, on `jobs` threads. `take` gets the
/// results one at a time in the order of the seeds, whatever the number of threads; when it returns
/// false the batch stops.
void run_batch(const WorldSettings& settings, std::uint64_t first, std::uint64_t last,
               unsigned jobs, const std::function<bool(const PricedResult&)>& take);

/// The world of one seed, and its price when the settings ask for that.
PricedResult run_priced(const WorldSettings& settings, std::uint64_t seed);

}  // namespace arcbid
