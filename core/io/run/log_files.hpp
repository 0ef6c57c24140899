// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

namespace arcbid {

/// The agents' event logs of a run, by name. Throws InputError where there is no folder of logs.
std::vector<std::filesystem::path> agents_logs(const std::filesystem::path& run);

}  // namespace arcbid
