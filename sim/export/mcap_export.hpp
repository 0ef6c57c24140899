// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/replay/run_archive.hpp"

namespace arcbid {

/// A run as an MCAP file of ROS 2 messages (docs/LOGS.md has the topics). Times are nanoseconds
/// since launch: a run does not say at which hour that was. `log_time` follows causality, and
/// `publish_time` is what the log's own clock said. A file that is there is replaced. The same run
/// gives the same bytes. The structure is read as the viewer reads it. Returns what is left out,
/// one line each: a structure that is not there or cannot be read. Throws RunError when it cannot
/// write.
std::vector<std::string> export_mcap(const RunArchive& run, const std::filesystem::path& file);

}  // namespace arcbid
