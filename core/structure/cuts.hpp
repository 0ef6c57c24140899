// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/structure/track.hpp"

namespace arcbid {

/// Cuts closed outlines into open tracks at their entry and exit points P_in/out (eq. 1): the
/// outline's points nearest to the outlines of the layer above and of the layer below. Where both
/// are one point, or would leave a piece shorter than `least_m`, or there is no neighbour, one cut
/// opens the ring. Open tracks go through unchanged.
std::vector<Track> cut_open(const std::vector<Track>& outlines, const std::vector<Track>& above,
                            const std::vector<Track>& below, double least_m);

}  // namespace arcbid
