// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/arcs/mission.hpp"
#include "core/auction/message.hpp"

namespace arcbid {

/// A table as somebody holds it at a decision.
struct HeldTable {
  StatementKey key;
  const Table* table = nullptr;  ///< null: its agent is dead, or has stated none
  bool is_news = false;          ///< since the decision before
};

/// A task that its receiver believed to have, until another's table was applied.
struct TableLoss {
  TaskId task;
  Belief winner;           ///< none: reset
  std::size_t sender = 0;  ///< roster position
  int row = 0;             ///< of Table I; 0 under ACBBA, whose table numbers none
  std::string rule;        ///< in words
};

/// Applies the policy's table to `before` as a decision does: `held`, by roster position, in that
/// order, what is believed of the dead aside.
std::vector<TableLoss> table_losses(PolicyKind policy, const std::vector<AgentId>& roster,
                                    AgentId self, const Table& before,
                                    const std::vector<HeldTable>& held);

}  // namespace arcbid
