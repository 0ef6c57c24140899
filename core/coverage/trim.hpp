// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/coverage/flyable.hpp"
#include "core/coverage/seer.hpp"

namespace arcbid {

/// An arc and what is seen along it. Ids are given at the very end.
struct SeenArc {
  Arc arc;
  std::vector<double> at_m;  ///< of each station, from the arc's start
  std::vector<Seen> seen;    ///< from each station
};

/// Looks from all stations of an arc, at most a metre apart.
std::vector<SeenArc> look_along(const Seer& seer, std::vector<Arc> arcs,
                                const std::vector<Wanted>& wanted, unsigned threads);

/// Which of the wanted samples are seen from any station. Less work than look_along: what has been
/// seen from some stations is not asked of the others.
std::vector<bool> seen_along(const Seer& seer, const std::vector<Arc>& arcs,
                             std::vector<Wanted> wanted, unsigned threads);

struct TrimLimits {
  double least_m;   ///< no arc becomes shorter
  double middle_m;  ///< a useless middle is cut out if it is at least that long
};

/// Leaves out what no sample needs: whole arcs, the least useful first, then ends, then long
/// middles. Every sample that was seen from some station still is.
std::vector<Arc> trimmed(std::vector<SeenArc> arcs, std::size_t samples, const TrimLimits& limits);

struct JoinLimits {
  double gap_m;  ///< the longest connection
  double arc_m;  ///< no arc becomes longer
};

/// Joins arcs that fill gaps to others, end to end, where the straight connection may be flown.
std::vector<Arc> joined_ends(std::vector<Arc> arcs, const Flyable& flyable,
                             const JoinLimits& limits);

}  // namespace arcbid
