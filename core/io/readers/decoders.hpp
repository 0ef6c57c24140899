// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/io/readers/source.hpp"

/// One decoder a format. Each throws InputError (file, line or field, value, what is legal) and
/// allocates for a count only when the file is long enough to back it.
namespace arcbid::readers {

/// Point Cloud Library's format 0.5 to 0.7: ascii, binary, binary_compressed.
RawGeometry decode_pcd(const Source& source);

/// Stanford polygon format 1.0: ascii, binary of both byte orders; a cloud when it has no faces.
RawGeometry decode_ply(const Source& source);

/// Wavefront OBJ: v and f; everything else is skipped.
RawGeometry decode_obj(const Source& source);

/// Stereolithography, ascii or binary.
RawGeometry decode_stl(const Source& source);

/// ASPRS LAS 1.0 to 1.4, point formats 0 to 10; LAZ is refused.
RawGeometry decode_las(const Source& source);

/// Text, three or more numbers a line.
RawGeometry decode_xyz(const Source& source);

}  // namespace arcbid::readers
