// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "core/structure/structure.hpp"

namespace arcbid {

/// What the user says about a file that the file itself does not.
struct ReadOptions {
  std::string unit = "m";  ///< m | cm | mm | ft | us-ft | in
  char up = 'z';           ///< x | y | z: the axis that points up in the file
};

/// Reads PCD (ascii, binary, binary_compressed), PLY, OBJ, STL, plain LAS and XYZ text into metres,
/// z up. The format is told by the content first and the name second. Drops NaN points, duplicates,
/// a cloud's far outliers, triangles without area and vertices that no triangle uses, each counted
/// in `warnings` (lines that begin with the file's name; docs/FORMATS.md explains them).
/// Coordinates more than 10 km from the origin are moved so that the bounding box's centre is at x
/// = y = 0; z stays. Throws InputError: one line with file, line or field, value, what is legal.
StructureInput read_structure(const std::filesystem::path& file, const ReadOptions& options);

}  // namespace arcbid
