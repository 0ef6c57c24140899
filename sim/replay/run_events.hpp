// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "sim/replay/playback.hpp"

namespace arcbid {

/// A moment that people look for: "start", "first conflict", "agreement", "agent 3 died", "end" ...
struct RunEvent {
  std::string name;
  std::size_t moments = 0;  ///< so many moments have passed when it has just happened
};

/// In causal order. A conflict: an agent hears of a bid for a task that it bids for itself.
std::vector<RunEvent> run_events(const RunArchive& run, const Playback& playback);

}  // namespace arcbid
