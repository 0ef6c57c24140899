// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "sim/replay/run_archive.hpp"

namespace arcbid {

/// The files that export_csv() writes into `folder`.
std::vector<std::filesystem::path> csv_files(const std::filesystem::path& folder);

/// A run as tables (docs/LOGS.md). Makes the folder; files that are there are replaced. The same
/// run gives the same bytes. Throws RunError when it cannot write.
void export_csv(const RunArchive& run, const std::filesystem::path& folder);

}  // namespace arcbid
