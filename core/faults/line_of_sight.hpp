// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/faults/schedule.hpp"

namespace arcbid {

/// Whether the straight line from `a_m` to `b_m` meets the box, its surface included (slab test).
bool meets(const Obstacle& box, const Vec3& a_m, const Vec3& b_m);

}  // namespace arcbid
