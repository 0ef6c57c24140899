// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "sim/world/checkers/arcs.hpp"

namespace arcbid {

/// What an agent came out with: its bundle in order, and its path.
struct Bidder {
  Uav uav;
  std::vector<Claim> bundle;
  std::vector<PathStop> path;
};

/// Holds an outcome against the sequential greedy allocation of `bidders`: again and again
/// everybody offers the free task of the highest marginal score at its (warped) bid, and the
/// highest bid wins. The outcome's own steps are taken one by one and none may be worse than the
/// best, recomputed here: ties within rounding pass, whichever way they went. Nobody offers what it
/// cannot fly, and at the end nobody could fly more.
void check_greedy(const Mission& mission, const std::vector<Stretch>& pieces,
                  const std::vector<Bidder>& bidders, const Transit& transit, TimeNs now_ns,
                  Findings& findings);

/// Seconds that the path takes, home to home.
double closed_path_s(const std::vector<Stretch>& pieces, const Uav& uav,
                     const std::vector<PathStop>& path, const Transit& transit);

}  // namespace arcbid
