// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "sim/world/checkers/step.hpp"

namespace arcbid {

/// A stretch of an arc with its ends in space, cut by the checkers themselves.
struct Stretch {
  std::uint32_t arc = 0;
  double from_m = 0, to_m = 0;
  Vec3 first_m = Vec3::Zero(), last_m = Vec3::Zero();
};

/// Cuts every arc into pieces as the mission asks for: of its piece length or else the shortest
/// arc's, longer ones where they would be more than its limit of tasks.
std::vector<Stretch> cut(const Mission& mission);

/// The split is what it must be, to the millimetre.
void check_split(const std::vector<Stretch>& expected, const std::vector<Task>& tasks,
                 Findings& findings);
/// Pieces that passed, bit for bit where the tasks are: a transit knows those places.
void take_places(const std::vector<Task>& tasks, std::vector<Stretch>& pieces);

/// The pieces of all who fly, and the tasks that nobody took, add up to every arc: no gap, no
/// overlap, to the millimetre.
void check_cover(const Mission& mission, std::vector<Piece> pieces, TimeNs now_ns,
                 Findings& findings);

}  // namespace arcbid
