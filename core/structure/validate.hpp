// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/structure/bridge_arcs.hpp"

namespace arcbid {

/// The box around all points of a cloud, or around the vertices that a mesh's triangles use.
struct Bounds {
  Vec3 low_m, high_m;
};

/// Throws InputError unless there is a point, all are finite and within 10^6 m of the origin,
/// triangles refer to vertices that exist, and there are fewer than 2^31 points and triangles.
Bounds checked_bounds(const Structure& structure);

/// Throws InputError, naming the field, unless the settings make sense together.
void validate(const CoverageSettings& settings);

/// Throws InputError unless `value` is finite and in [least, most].
void require_range(const char* field, double value, double least, double most);

}  // namespace arcbid
