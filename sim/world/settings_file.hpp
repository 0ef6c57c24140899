// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "sim/world/spec.hpp"

namespace arcbid {

/// Reads a config of `arcbid sim` (docs/SIMULATOR.md). Throws InputError: everything wrong in the
/// file, one line each.
WorldSettings load_worlds(const std::filesystem::path& file);
WorldSettings parse_worlds(const std::string& text, const std::filesystem::path& file);

/// A table of every key, what is legal, its default and meaning, in Markdown.
std::string worlds_reference();

}  // namespace arcbid
