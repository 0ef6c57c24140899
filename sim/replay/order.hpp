// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "sim/replay/run_archive.hpp"

namespace arcbid {

/// One step of one life.
struct Moment {
  std::size_t life = 0;  ///< in RunArchive::lives
  std::size_t mark = 0;
  TimeNs t_ns = 0;  ///< by its log; where that would be before its cause, the cause's time
};

/// All steps in one order that contradicts nobody: each life's own, and no message heard before it
/// was sent (messages are known by their ids). Among what neither decides, the earlier by its log's
/// own clock comes first. Hosts' clocks may differ as they like.
std::vector<Moment> causal_order(const RunArchive& run);

}  // namespace arcbid
