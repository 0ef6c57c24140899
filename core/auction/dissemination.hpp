// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/auction/view.hpp"

namespace arcbid {

/// When to say what again: anti-entropy over links that drop. Every status message carries the keys
/// of the sender's view; whoever lacks a statement is served by its author at once, and, should
/// that fail, by a relay after some patience (without it every holder relays at the same moment).
/// Members are roster positions.
class Dissemination {
 public:
  struct Timing {
    TimeNs resend_ns;    ///< between two tries of one's own statement
    TimeNs patience_ns;  ///< before another's statement is relayed
  };
  Dissemination(std::size_t members, std::size_t self, Timing timing);

  /// One key that a member holds, by roster position.
  struct Holding {
    std::size_t author;
    StatementKey key;
  };
  /// `member` said at `stamp` that it holds `holdings`, or, when not `whole`, that these are new.
  /// It replaces what was known of it, never by a maximum, for a reborn agent holds less than it
  /// did; older stamps change nothing.
  void holds(std::size_t member, const Heartbeat& stamp, bool whole,
             const std::vector<Holding>& holdings);
  /// `member` is silent: nobody is served on its account until it is heard again. Somebody who is
  /// dead to this agent and still heard is served: after a partition each side has buried the
  /// other, and neither would begin.
  void forget(std::size_t member);
  /// The view has a new statement of `member`.
  void learnt(std::size_t member, TimeNs now);

  /// Members whose statements should be sent now; marks them as sent.
  std::vector<std::size_t> due(const View& view, TimeNs now);
  /// Whether `member` is known to hold everything that `view` holds.
  bool is_up_to_date(std::size_t member, const View& view) const;
  /// Whether some living member is known to lack something.
  bool anyone_lacks(const View& view) const;

 private:
  bool lacks(std::size_t reader, std::size_t author, const View& view) const;
  bool wanted(std::size_t author, const View& view) const;
  TimeNs wait_ns(std::size_t author, const View& view) const;

  std::size_t self_;
  Timing timing_;
  std::vector<Heartbeat> stamps_;
  std::vector<std::vector<StatementKey>> known_;  // by member; empty: never heard
  std::vector<TimeNs> learnt_ns_;  // the newest statement, or the first that waits to be passed on
  std::vector<bool> is_awaited_;   // somebody lacked it when that was last asked
  std::vector<std::optional<TimeNs>> said_ns_;  // when its newest statement was last sent from here
};

}  // namespace arcbid
