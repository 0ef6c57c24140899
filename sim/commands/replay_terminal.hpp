// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/replay/player.hpp"

namespace arcbid {

/// Plays on a terminal until the end, or until it is told to quit. `step`: how many shown moments a
/// key moves.
void play_on_terminal(const RunArchive& run, const Playback& playback, Player& player, int step);

/// What would be shown, without a terminal and at once: a line for each shown moment, between the
/// status before and after. `most`: no more moments; 0: all.
void play_plainly(const RunArchive& run, const Playback& playback, Player& player, int most);

}  // namespace arcbid
