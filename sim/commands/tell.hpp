// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <cstdio>

#include "sim/replay/run_archive.hpp"

namespace arcbid {

/// Says on standard error what of a run is shown by another build's records.
inline void tell_unverifiable(const RunArchive& run) {
  for (const std::string& line : unverifiable(run)) fmt::print(stderr, "{}\n", line);
}

}  // namespace arcbid
