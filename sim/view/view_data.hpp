// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "sim/replay/playback.hpp"

namespace arcbid {

/// What the viewer shows of a run (docs/VIEWER.md has the format): only what its logs say, and
/// what follows from that.
nlohmann::json view_data(const RunArchive& run);

/// Parts of it. `views`: z and y of every life, change by change; `decisions`: what was claimed;
/// `states` and `events` in causal order.
nlohmann::json auction_data(const RunArchive& run, const Playback& playback);
/// Messages of each directed link, by time: sent, and of them lost, delayed and duplicated.
nlohmann::json links_data(const RunArchive& run);
/// What the certificate of a run directory says; null where there is none. Of files that are
/// damaged it has what the others say, and `problem`: one line that names the file.
nlohmann::json coverage_data(const std::filesystem::path& run);

/// Seconds since launch.
inline double seconds(TimeNs t_ns) {
  return static_cast<double>(t_ns) * 1e-9;
}

}  // namespace arcbid
