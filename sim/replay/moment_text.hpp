// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/replay/playback.hpp"

namespace arcbid {

std::string_view name_of(Playback::State state);

/// What one moment was about, in a line; and a line for whose tasks it changed owners.
std::vector<std::string> text_of(const RunArchive& run, const Playback& playback,
                                 std::size_t moment);

/// What holds after the first `moments` moments, in a line: the arc set, the membership, agents'
/// states and rounds, tasks held.
std::string status_of(const RunArchive& run, const Playback& playback, std::size_t moments);

}  // namespace arcbid
