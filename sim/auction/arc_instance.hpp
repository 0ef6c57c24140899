// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "core/arcs/mission.hpp"

namespace arcbid {

/// Reads an instance of arcs: a JSON file with `agents`, a list of {"home": [x, y, z]} with
/// `speed_mps` where it is not 1, `endurance_s` and `payload` where these are limited, and `arcs`,
/// a list of polylines [[x, y, z], ...] or, where one needs a payload, {"points": [[x, y, z], ...],
/// "payload": "camera"}. Metres. Points
/// that repeat the one before are left out. The mission has nothing but the arcs and the fleet,
/// whose ids are the places in the file + 1. Throws InputError that names the file and the entry.
Mission read_arc_instance(const std::filesystem::path& file);

}  // namespace arcbid
