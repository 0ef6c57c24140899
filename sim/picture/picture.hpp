// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace arcbid {

/// The routes of a run directory as one SVG drawing, seen from above one corner: a colour an agent
/// (safe for colour-blind eyes), arcs as solid lines, transits dashed, homes as dots. Throws
/// InputError when the run cannot be read.
std::string draw_routes(const std::filesystem::path& run);

}  // namespace arcbid
