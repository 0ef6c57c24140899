// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "sim/auction/instance.hpp"

namespace arcbid::testing {

/// Agents and tasks at random in a square of 1000 m; on a grid of 5 x 5 places with `ties`.
Instance random_points(std::uint64_t seed, std::uint32_t agents, std::uint32_t tasks,
                       bool ties = false);

/// The sequential greedy allocation by plain search: again and again the best offer of all agents,
/// each offering the task of its highest gain at its (warped) bid. Ties: the lower agent, then the
/// lower task.
std::vector<std::vector<TaskId>> sequential_greedy(const Instance& instance,
                                                   const AuctionSettings& settings);

/// The highest sum of rewards that any allocation reaches, by trying all (few tasks only).
double best_score(const Instance& instance, std::uint32_t bundle_limit, double discount_per_s);

}  // namespace arcbid::testing
