// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "sim/replay/run_archive.hpp"

namespace arcbid {

/// All that was stated and decided in a run, read once: what is asked of it costs no file.
class RunIndex {
 public:
  explicit RunIndex(const RunArchive& run);

  /// A decision that changed what its agent states.
  struct Decision {
    std::size_t mark = 0;
    std::uint32_t round = 0;
    StatementKey key;
  };
  /// An agent that was declared dead, or came back.
  struct Notice {
    std::size_t mark = 0;
    AgentId agent;
    bool returned = false;
  };
  const std::vector<Decision>& decisions(std::size_t life) const { return lives_[life].decisions; }
  const std::vector<Notice>& notices(std::size_t life) const { return lives_[life].notices; }
  /// Null for a tombstone, and for what nobody who is on record has said or heard.
  const StatementBody* body(AgentId agent, const StatementKey& key) const;

 private:
  using Bodies = std::map<std::pair<AgentId, StatementKey>, StatementBody>;
  struct Life {
    std::vector<Decision> decisions;
    std::vector<Notice> notices;
    Bodies bodies;
  };
  static Life read(const LifeLog& log);
  static void note(Life& life, std::size_t mark, AgentId self, Step step);

  std::vector<Life> lives_;
  Bodies bodies_;
};

}  // namespace arcbid
