// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/arcs/airspace.hpp"

namespace arcbid {

/// One byte a cell, 1 where it is free; x runs fastest, then y, then z.
using Cells = std::vector<std::uint8_t>;

/// Most cells of a model: what an agent is ready to hold.
inline constexpr std::uint64_t kMostCells = 8'000'000;

/// Lengths of runs of cells that are as their neighbour at y - 1 (at y = 0: at z - 1; before the
/// first: free), then that are not, and so on in turn: base-128 numbers, low digits first, the
/// high bit set on all but the last. Rows of a bridge are alike, so most of them cost nothing.
std::vector<std::uint8_t> encode_runs(const Cells& free, const std::array<std::uint32_t, 3>& cells);

/// Why the model cannot be what a coordinator made: nothing if it can. Looks at every field but the
/// arcs that accesses lead to. An empty model is sound.
std::optional<std::string> unsound(const Airspace& airspace);

/// The cells of a sound model that is not empty.
Cells decode_runs(const Airspace& airspace);

}  // namespace arcbid
