// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/io/readers/source.hpp"

namespace arcbid::readers {

/// Drops what no planner can use, and counts it in `raw.warnings`: points that are not finite,
/// equal points, a cloud's outliers; triangles without area, and a mesh's vertices that no triangle
/// uses. What is left keeps its order. Throws InputError when nothing is left.
void clean(const Source& source, RawGeometry& raw);

}  // namespace arcbid::readers
