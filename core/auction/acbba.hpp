// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/auction/bundle.hpp"
#include "core/auction/decision_table.hpp"
#include "core/auction/policy.hpp"

namespace arcbid {

/// What the table of asynchronous CBBA (Johnson, Ponda, Choi, How 2011) makes an agent do and say.
enum class AcbbaAction : std::uint8_t {
  leave,
  update,   ///< take over the sender's belief, with its time
  reset,    ///< no winner, as of now
  refresh,  ///< the agent's own bid, as of now
};
enum class Rebroadcast : std::uint8_t { nothing, theirs, own, empty };
struct AcbbaReaction {
  AcbbaAction action = AcbbaAction::leave;
  Rebroadcast say = Rebroadcast::nothing;
  friend bool operator==(const AcbbaReaction&, const AcbbaReaction&) = default;
};

/// The rule for a pair of beliefs. `higher`: the sender's bid beats the receiver's, ties going to
/// the lower winner. `age`: the sender's time less the receiver's, by sign. Rules that read "equal
/// bids" in the published table, and the pair (m, n) with equal bids, which has none there, follow
/// the tie rule. The pair (m, none) also asks for a later time: without, a belief and the
/// withdrawal that crosses it swap places for ever, on complete graphs too.
AcbbaReaction acbba_rule(Who sender, Who receiver, bool higher, int age);

/// A belief about one task and when its bid was made.
struct TimedBelief {
  Belief belief;
  std::uint64_t time = 0;
};

/// One agent under ACBBA: y_i, z_i and t_i (the time of each winning bid), and the bundle. Times
/// are Lamport's logical clocks, so that no clocks are compared.
class AcbbaState {
 public:
  AcbbaState(AgentId self, Bundle bundle, std::size_t tasks);

  /// Applies the table to what `sender` says about task j. Returns what is to be rebroadcast.
  Rebroadcast receive(AgentId sender, TaskId j, const TimedBelief& theirs);

  /// No winner may be this one any more: the table has no rule for death.
  void forget(AgentId dead);

  /// Releases the first task that was lost and everything bundled after it, then bids again.
  /// Returns the tasks whose beliefs changed.
  std::vector<TaskId> rebid();

  TimedBelief belief(TaskId j) const {
    return {table_.beliefs[j.value], table_.timestamps[j.value]};
  }
  const Table& table() const { return table_; }  ///< timestamps by task
  const Bundle& bundle() const { return bundle_; }
  AgentId self() const { return self_; }

 private:
  void set(TaskId j, const Belief& belief, std::uint64_t time);

  AgentId self_;
  Bundle bundle_;
  Table table_;
  std::uint64_t clock_ = 0;
};

/// ACBBA on the newest statements of all: a decision applies every table that has changed since it
/// was applied last. Whole tables are stated, so what the published table would rebroadcast is said
/// anyway, and said again until it arrives.
class AcbbaPolicy final : public Policy {
 public:
  explicit AcbbaPolicy(AcbbaState state) : state_(std::move(state)) {}

  Decision decide(const View& view) override;
  StatementBody statement() const override { return state_.table(); }
  std::vector<Belief> winners(const View&) const override { return state_.table().beliefs; }
  bool agrees(const View& view) const override;
  const std::vector<PathStop>& path() const override { return state_.bundle().path(); }

 private:
  AcbbaState state_;
  std::vector<StatementKey> applied_;  // by roster position
};

}  // namespace arcbid
