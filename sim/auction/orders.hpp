// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/auction/bundle_replay.hpp"
#include "core/auction/message.hpp"

namespace arcbid {

using Bytes = std::vector<std::uint8_t>;

/// A bundle and the key that it was stated under.
struct Said {
  StatementKey key;
  std::vector<Claim> bundle;
  friend bool operator==(const Said&, const Said&) = default;
};

/// A statement as the order of its tasks, for links on which nothing is lost, as the difference to
/// what the receiver has of the same author, whom it does not name. No bids travel: the receiver
/// recomputes them, bit for bit (core/auction/bundle_replay.hpp). Numbers are in base 128, the
/// least digit first, the top bit of a byte saying that more follow; so one statement's bytes tell
/// where the next one's begin:
///   version - before's            within one life; else 0, the life, the version
///   2 * entries [+ 1]             + 1: all bids follow after the entries, 8 bytes each
///   entry: 2 * task               or
///          2 * place + 1, count   so many tasks of the bundle before, from this place on
/// Bids follow where the author's are not those of the replay (that is claims-keep under MiniMax).
/// `replay` is the author's; what it holds decides how fast this is, and nothing else. The living
/// only.
Bytes encode(const Said& before, const Said& now, BundleReplay& replay);

/// What was encoded; none where the bytes are no statement that can follow `before`, of `tasks`
/// tasks.
std::optional<Said> decode(std::span<const std::uint8_t> bytes, const Said& before,
                           std::size_t tasks, BundleReplay& replay);

}  // namespace arcbid
