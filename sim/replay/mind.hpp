// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/replay/run_index.hpp"
#include "sim/replay/table_losses.hpp"

namespace arcbid {

/// What one life knew whenever it decided, followed from decision to decision.
class Mind {
 public:
  Mind(const RunArchive& run, const RunIndex& index, std::size_t life);

  /// The next decision that changed its statement.
  void decide(const RunIndex::Decision& decision);

  /// Its bundle before and after that decision.
  const std::vector<Claim>& before() const { return before_; }
  const std::vector<Claim>& after() const { return after_; }
  /// The best bid of the others for each task, as known to it then, and at the decision before.
  const std::vector<Belief>& rivals() const { return rivals_; }
  const std::vector<Belief>& rivals_before() const { return rivals_before_; }

  /// Somebody's bid, or table, that took a task from it.
  struct Loss {
    Belief winner;                    ///< nobody: the task became free
    std::optional<std::size_t> mark;  ///< the step that brought the news
    int row = 0;                      ///< of Table I
    std::string rule;
  };
  /// None: nobody took that entry of the bundle before.
  std::optional<Loss> loss(const Claim& claim) const;

  /// The newest that it had come to hold of `agent` since the decision before.
  const Learnt* news_of(AgentId agent) const;
  /// The tasks of `agent`, by all that it knew before the step `mark`.
  std::vector<TaskId> tasks_of(AgentId agent, std::size_t mark) const;
  /// What it believes at the end of its record: whose tombstones it holds.
  bool buried(AgentId agent, std::uint64_t incarnation) const;
  /// Its last statement; null: none.
  const StatementBody* said() const { return own_; }

 private:
  using Cursors = std::vector<std::size_t>;  // by member: how much of learnt() was heard
  std::size_t position(AgentId agent) const;
  const Learnt* held(std::size_t member, const Cursors& heard) const;
  /// With `end`: all that it learnt before that step.
  Cursors heard_before(Cursors heard, std::size_t end) const;
  std::vector<Belief> best_of_others(const Cursors& heard) const;
  void take_table(const Table& before, const Table& after);
  std::vector<HeldTable> tables() const;
  std::optional<std::size_t> first_to_beat(std::size_t member, const Claim& claim) const;

  const RunArchive& run_;
  const RunIndex& index_;
  const LifeLog& log_;
  std::vector<AgentId> roster_;
  std::size_t self_;
  Cursors heard_, heard_last_;
  const StatementBody* own_ = nullptr;
  std::vector<Claim> before_, after_;
  std::vector<Belief> rivals_, rivals_before_;
  std::vector<TableLoss> table_losses_;
};

}  // namespace arcbid
