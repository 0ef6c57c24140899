// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "sim/replay/doctor.hpp"

namespace arcbid {

/// Writes a run directory with everything in `run` that is intact: its logs' records into sound
/// logs, under their numbers and with their kinds and meta, and all other files as they are. A
/// mission or a schema that one agent's log has lost comes from another's: all have the same.
/// Throws InputError when `to` is not empty, RunError when it cannot be written.
void salvage(const std::filesystem::path& run, const RunReport& report,
             const std::filesystem::path& to);

}  // namespace arcbid
