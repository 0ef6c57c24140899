// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "sim/replay/doctor.hpp"
#include "sim/replay/life_log.hpp"

namespace arcbid {

/// What logs say of messages between agents: of each, who has it on record.
class Evidence {
 public:
  /// What all logs say, `log` counted by its place in the reports.
  void sent(std::size_t log, const MessageId& message);
  void heard(const MessageId& message, TimeNs t_ns);

  /// Fills in `heard_only`, and appends reports of lives that others heard but of which there is no
  /// log.
  void judge(std::vector<LogReport>& logs) const;

 private:
  struct Spoken {
    std::uint64_t incarnation = 0, sequence = 0;  ///< the highest on record
  };
  std::size_t life_of(const MessageId& message, std::vector<LogReport>& logs) const;

  std::vector<MessageId> sent_;
  std::map<MessageId, TimeNs> heard_;
  std::map<std::size_t, Spoken> last_;  ///< by log
};

}  // namespace arcbid
