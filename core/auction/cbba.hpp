// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/auction/bundle.hpp"
#include "core/auction/decision_table.hpp"
#include "core/auction/policy.hpp"

namespace arcbid {

/// What one of the two parties to a message believes about a task, and its s.
struct Side {
  AgentId agent;
  const Belief& belief;
  const std::vector<std::uint64_t>& timestamps;
};
/// The row of Table I that applies, and what it says.
struct Fired {
  const Row& row;
  Action action;
};
Fired fired(const std::vector<AgentId>& roster, const Side& sender, const Side& receiver);

/// A statement's key as a timestamp that grows with it: 42 bits of milliseconds, 22 of version.
std::uint64_t timestamp_of(const StatementKey& key);

/// The state of one agent under CBBA (Choi, Brunet, How 2009): y_i, z_i, s_i and the bundle; and
/// its two phases. Timestamps are any numbers that grow with news: rounds, times or versions. As
/// published, an agent keeps what it bundled before the first task that it was outbid on; with
/// `rebuilds` it bids for everything anew, which is what makes CBBA equal to sequential greedy.
class CbbaState {
 public:
  CbbaState(AgentId self, std::vector<AgentId> roster, Bundle bundle, std::size_t tasks,
            bool rebuilds = false);

  /// Applies Table I to everything `sender` (roster position) believes, then brings s_i up to date:
  /// s_ik = `now`, and for others the later of s_im and s_km. Returns whether a belief changed.
  bool receive(std::size_t sender, const Table& table, std::uint64_t now);

  /// No winner may be one of these any more: Table I has no rule for death, so it is an explicit
  /// step.
  void forget(AgentId dead);

  /// Releases the first task that was lost and everything bundled after it.
  void release();
  /// Bids for more; with `rebuilds` for everything anew. Returns whether the bundle changed.
  bool bid();

  bool is_self(std::size_t position) const { return roster_[position] == self_; }
  const Table& table() const { return table_; }
  const Bundle& bundle() const { return bundle_; }

 private:
  bool claim();
  bool apply(AgentId sender, const Table& table, std::size_t first, std::size_t last);

  AgentId self_;
  std::vector<AgentId> roster_;
  Bundle bundle_;
  Table table_;
  bool rebuilds_;
};

/// Published CBBA on the newest statements of all: a decision is one synchronous round in which
/// every living agent's newest table arrives, and it is settled when such a round changes nothing.
/// Versions of statements serve as timestamps, so no clock is compared.
class CbbaPolicy final : public Policy {
 public:
  explicit CbbaPolicy(CbbaState state) : state_(std::move(state)) {}

  Decision decide(const View& view) override;
  StatementBody statement() const override { return state_.table(); }
  std::vector<Belief> winners(const View&) const override { return state_.table().beliefs; }
  bool agrees(const View& view) const override;
  const std::vector<PathStop>& path() const override { return state_.bundle().path(); }

 private:
  CbbaState state_;
};

}  // namespace arcbid
