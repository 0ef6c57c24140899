// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/replay/table_losses.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/auction/acbba.hpp"
#include "core/auction/cbba.hpp"

namespace arcbid {
namespace {

std::string pair_of(Who sender, Who receiver) {
  return fmt::format("the sender believes in {}, the receiver in {}", name(sender), name(receiver));
}

/// An agent's table while others are applied to it, as far as its own tasks go.
class Receiver {
 public:
  Receiver(const std::vector<AgentId>& roster, AgentId self, const Table& before)
      : roster_(roster), self_(self), table_(before) {
    for (std::uint32_t j = 0; j < before.beliefs.size(); ++j)
      if (before.beliefs[j].winner == self) own_.push_back({j});
  }

  void hear_cbba(std::size_t k, const HeldTable& held, const std::vector<HeldTable>& all) {
    const Table& said = *held.table;
    for (const TaskId j : own_) {
      const Belief theirs = of_the_living(said.beliefs[j.value], all);
      Belief& ours = table_.beliefs[j.value];
      if (theirs == ours) continue;
      const Fired rule =
          fired(roster_, {roster_[k], theirs, said.timestamps}, {self_, ours, table_.timestamps});
      if (rule.action == Action::leave) continue;
      const bool was_own = ours.winner == self_;
      ours = rule.action == Action::update ? theirs : Belief{};
      if (was_own && ours.winner != self_)
        lost_.push_back(
            {j, ours, k, rule.row.number,
             fmt::format("Table I, row {} ({}): {}", rule.row.number,
                         pair_of(rule.row.sender, rule.row.receiver), name(rule.action))});
    }
    for (std::size_t m = 0; m < roster_.size(); ++m)
      table_.timestamps[m] = std::max(table_.timestamps[m], said.timestamps[m]);
    table_.timestamps[k] = timestamp_of(held.key);
  }

  void hear_acbba(std::size_t k, const HeldTable& held, const std::vector<HeldTable>& all) {
    for (const TaskId j : own_) {
      const Belief theirs = of_the_living(held.table->beliefs[j.value], all);
      Belief& ours = table_.beliefs[j.value];
      std::uint64_t& time = table_.timestamps[j.value];
      const std::uint64_t said = held.table->timestamps[j.value];
      const auto [sends, has] = believed(self_, roster_[k], theirs.winner, ours.winner);
      const bool higher = theirs.winner && beats(theirs.bid, *theirs.winner, ours);
      const AcbbaAction action =
          acbba_rule(sends, has, higher, (said > time) - (said < time)).action;
      if (action == AcbbaAction::leave || action == AcbbaAction::refresh) continue;
      const bool was_own = ours.winner == self_;
      ours = action == AcbbaAction::update ? theirs : Belief{};
      time = action == AcbbaAction::update ? said : std::max(said, time) + 1;
      if (was_own && ours.winner != self_)
        lost_.push_back({j, ours, k, 0,
                         fmt::format("ACBBA's table ({}): {}", pair_of(sends, has),
                                     action == AcbbaAction::update ? "update" : "reset")});
    }
  }

  std::vector<TableLoss> lost() { return std::move(lost_); }

 private:
  /// A decision takes nobody for a winner who is known to be dead.
  Belief of_the_living(const Belief& belief, const std::vector<HeldTable>& all) const {
    for (std::size_t k = 0; k < roster_.size(); ++k)
      if (all[k].key.dead && belief.winner == roster_[k]) return {};
    return belief;
  }

  const std::vector<AgentId>& roster_;
  AgentId self_;
  Table table_;
  std::vector<TaskId> own_;
  std::vector<TableLoss> lost_;
};

}  // namespace

std::vector<TableLoss> table_losses(PolicyKind policy, const std::vector<AgentId>& roster,
                                    AgentId self, const Table& before,
                                    const std::vector<HeldTable>& held) {
  Receiver receiver(roster, self, before);
  for (std::size_t k = 0; k < roster.size(); ++k) {
    if (!held[k].table || roster[k] == self) continue;
    if (policy != PolicyKind::acbba)
      receiver.hear_cbba(k, held[k], held);
    else if (held[k].is_news)
      receiver.hear_acbba(k, held[k], held);
  }
  return receiver.lost();
}

}  // namespace arcbid
