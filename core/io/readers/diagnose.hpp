// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/io/readers/source.hpp"
#include "core/io/structure_reader.hpp"

namespace arcbid::readers {

/// Metres in one unit of `options.unit`. Throws InputError for an unknown unit or up axis.
double metres_per_unit(const ReadOptions& options);

/// Refuses longitude and latitude in degrees, whether the file says so or its extents do.
void refuse_degrees(const Source& source, const RawGeometry& raw);

/// The file's unit and axes to metres, z up; then, when the centre of the bounding box is far from
/// the origin, to x = y = 0 (a line in `raw.warnings` says by how much).
void to_local_frame(RawGeometry& raw, const ReadOptions& options);

/// Judges the extents in metres: refuses a single spot, and sizes that no structure has; what only
/// looks odd becomes a line in `raw.warnings`.
void judge_extents(const Source& source, RawGeometry& raw, const ReadOptions& options);

}  // namespace arcbid::readers
