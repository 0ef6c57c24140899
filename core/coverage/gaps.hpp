// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/coverage/flyable.hpp"
#include "core/coverage/seer.hpp"
#include "core/coverage/visibility.hpp"

namespace arcbid {

/// A place to look from, and what it adds.
struct View {
  Waypoint waypoint;
  Seen seen;
};

/// What is to be filled: samples that no arc covers although they can be seen.
struct Gap {
  std::vector<Wanted> wanted;                  ///< of all samples: how, or not
  Seen samples;                                ///< those wanted
  std::vector<Visibility::Witness> witnesses;  ///< theirs, in the same order
};

/// Views that together see all of the gap: first greedily from a lattice of flyable places, then
/// from the witnesses of what is left.
std::vector<Waypoint> views_of_gap(const Seer& seer, const Flyable& flyable, const Gap& gap,
                                   unsigned threads);

}  // namespace arcbid
