// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/coverage/surface.hpp"

namespace arcbid {

/// A sphere for each point of a cloud, just large enough to close the gaps to its neighbours', with
/// the surface's normal there (docs/COVERAGE.md). Metres.
std::vector<Surfel> surfels_of(const std::vector<Vec3>& points, unsigned threads);

}  // namespace arcbid
