// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/auction/message.hpp"

namespace arcbid {

/// V: the newest statement of every member of the roster. Only grows: merging is commutative,
/// associative and idempotent, so loss, delay, duplication and reordering change nothing but when.
class View {
 public:
  /// `roster`: ascending agent ids. Nobody has been heard.
  explicit View(std::vector<AgentId> roster);

  /// Keeps the statement if it is newer than what is held. Returns whether V changed. Its agent
  /// must be of the roster.
  bool merge(Statement statement);

  const std::vector<AgentId>& roster() const { return roster_; }
  std::optional<std::size_t> position(AgentId agent) const;  ///< in the roster
  const Statement& of(std::size_t position) const { return statements_[position]; }
  StatementKey key(std::size_t position) const { return statements_[position].key; }
  bool heard(std::size_t position) const;  ///< alive or dead, something is known of it
  bool dead(std::size_t position) const { return statements_[position].key.dead; }
  bool dead(AgentId agent) const;
  std::vector<StatementKey> keys() const;  ///< in roster order

  /// H: a hash of all keys and contents.
  std::uint64_t hash() const;

 private:
  std::vector<AgentId> roster_;
  std::vector<Statement> statements_;
  std::vector<std::uint64_t> contents_;  // digest of each statement
};

/// z and y as they follow from claims alone: for every task the highest bid of the living, the
/// lower id on ties; `without` leaves one agent's own claims out.
std::vector<Belief> best_claims(const View& view, std::size_t tasks,
                                std::optional<AgentId> without = std::nullopt);

}  // namespace arcbid
