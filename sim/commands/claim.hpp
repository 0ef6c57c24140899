// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <filesystem>

#include "core/base/error.hpp"

namespace arcbid {

/// Makes the directory of --out; before the work, not after it. Throws InputError unless it is then
/// empty.
inline void claim(const std::filesystem::path& out) {
  std::error_code error;
  std::filesystem::create_directories(out, error);
  if (error)
    throw InputError(fmt::format("--out {}: {}; legal is a directory that is new or empty",
                                 out.string(), error.message()));
  if (!std::filesystem::is_empty(out))
    throw InputError(fmt::format(
        "--out {}: is not empty; legal is a directory that is new or empty", out.string()));
}

}  // namespace arcbid
