// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "sim/replay/explain.hpp"

namespace arcbid {

/// One agent once more, its logged inputs without one message. What the others hear of it stays as
/// it was: that they would have answered otherwise is not followed.
struct WithoutMessage {
  MessageId message;
  std::size_t copies = 0;  ///< how often it was heard
  struct Decision {
    TimeNs t_ns = 0;
    std::uint32_t round = 0;
    bool has_task = false;
    double bid = 0;  ///< for the task
  };
  std::vector<Decision> decisions;     ///< the next ones, until the task was dropped after all
  TimeNs dropped_ns = 0;               ///< by the log
  std::optional<TimeNs> dropped_late;  ///< without the message; none: never
  /// By what the same statement, or a newer one, came after all.
  std::optional<Source> instead;
  TimeNs instead_ns = 0;
  std::uint64_t bids = 0, bids_logged = 0;  ///< sent from the message on, without it and with it
};

/// Of an outbid or released task, when a message was the cause; else none. Throws InputError, one
/// line, for a log of another schema: this build's core may not be what wrote it.
std::optional<WithoutMessage> without_message(const RunArchive& run, const Explanation& drop);

/// The last time that somebody who does not have the task now dropped it; null: nobody did.
const Explanation* decisive_drop(const std::vector<Explanation>& story);
/// The last death that made the task free; null: none did.
const Explanation* decisive_death(const std::vector<Explanation>& story);

}  // namespace arcbid
