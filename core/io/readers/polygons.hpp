// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/io/readers/source.hpp"

namespace arcbid::readers {

/// A mesh file's faces as it lists them, flat: face i has the corners [ends[i-1], ends[i]).
struct Polygons {
  std::vector<std::int64_t> corners;  ///< vertex indices from 0; may still be out of range
  std::vector<std::size_t> ends;
  std::vector<std::size_t> lines;  ///< the line of each face; empty in a binary file
};

/// Cuts the polygons into triangles and adds them to `raw`. Convex ones become fans, concave ones
/// are partitioned in the plane of their Newell normal. Faces with fewer than three corners are
/// counted in a warning. Throws InputError for an index outside `raw.points`, naming the line or
/// face.
void add_triangles(const Source& source, const Polygons& polygons, RawGeometry& raw);

}  // namespace arcbid::readers
