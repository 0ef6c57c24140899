// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/replay/playback.hpp"
#include "sim/replay/run_index.hpp"

namespace arcbid {

/// The message by which something became known.
struct Source {
  MessageId id;
  bool is_relay = false;
};

/// One thing that happened to a task, and why.
struct Explanation {
  enum class Kind : std::uint8_t {
    bid,       ///< the agent took it into its bundle, or bids something else for it now
    outbid,    ///< the agent dropped it, for somebody else's bid
    released,  ///< the agent dropped it, for something that happened to another task
    death,     ///< the agent declared its winner dead, or heard that somebody did
    owner,     ///< the agent has it at the end of the auction
    exchanged  ///< the agent flies it: exchanges after the auction gave it what another had won
  };
  TimeNs t_ns = 0;
  AgentId agent;
  std::string text;
  Kind kind = Kind::bid;
  TaskId task;
  std::uint32_t round = 0;
  std::size_t place = 0;  ///< in its bundle, from 1: of a bid, or of what was dropped
  double bid = 0;         ///< the agent's own
  Belief rival;           ///< best of the others as far as known, or whoever won
  std::optional<Source> source;
  int row = 0;  ///< of Table I; 0: none
  std::size_t life = 0, mark = 0;
};
std::string_view name_of(Explanation::Kind kind);
/// "bid 2/1795647590236/45": sender, incarnation, sequence.
std::string describe(const Source& source);

/// Why who has what. Everything is worked out once, from what the logs say; asking is cheap.
/// Places in bundles are as stated with claims; tables do not say them, and they go by the bids.
class Explainer {
 public:
  Explainer(const RunArchive& run, const Playback& playback);

  /// In causal order; the last one names who flies it, if somebody does.
  const std::vector<Explanation>& explain(TaskId task) const { return by_task_.at(task.value); }
  /// What one agent gained and lost, in its order.
  std::vector<Explanation> explain(AgentId agent) const;
  /// Who has what at the end of the auction, for all that is on record: an entry for each task.
  const std::vector<Belief>& owners() const { return owners_; }
  const RunIndex& index() const { return index_; }

 private:
  friend class Narrator;
  void tell_owners(TimeNs end_ns);
  void tell_exchanges(const RunArchive& run, const Playback& playback, TimeNs end_ns);

  RunIndex index_;
  std::vector<std::vector<Explanation>> by_task_;
  std::vector<Belief> owners_;
};

/// For one task only; whoever asks for many makes an Explainer.
std::vector<Explanation> explain(const RunArchive& run, const Playback& playback, TaskId task);

}  // namespace arcbid
