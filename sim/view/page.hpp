// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace arcbid {

/// The viewer as it was built (sim/viewer), without a run in it. `programs`: where arcbid is; the
/// page is in ../share. Throws InputError where it was not built, saying what that takes.
std::string viewer_page(const std::filesystem::path& programs);

/// The page with a run's data inside: one file that opens from disk.
std::string report_page(std::string page, const std::string& data);

std::string gzip(std::string_view text);

}  // namespace arcbid
