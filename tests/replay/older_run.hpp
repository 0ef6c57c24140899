// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace arcbid::testing {

/// Writes a run's logs again as another arcbid, "0.0.9 01dbeef", would have left them: `change`
/// makes another schema of that of a kind. What is not CDR stays.
void make_older(
    const std::filesystem::path& run,
    const std::function<std::string(const std::string& kind, std::string schema)>& change);

/// For make_older(): a field less, fields more, another order, a narrower number. Some values are
/// lost.
std::string otherwise(const std::string& kind, std::string schema);
/// The same where nothing is lost.
std::string otherwise_but_whole(const std::string& kind, std::string schema);

}  // namespace arcbid::testing
