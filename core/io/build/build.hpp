// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace arcbid {

/// Which arcbid this is: on record with every run.
std::string_view build_version();
/// The git commit, "+" behind it when there were changes; empty: it was not built from a clone.
std::string_view build_commit();

}  // namespace arcbid
