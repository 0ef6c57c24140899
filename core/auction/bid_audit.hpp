// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/auction/bundle_replay.hpp"
#include "core/auction/message.hpp"

namespace arcbid {

/// Bids are no matter of opinion: they follow from the mission, so that everybody can tell a false
/// one, whoever passed it on. Claims come in the order in which they were taken and are recomputed
/// one by one; too low is as false as too high. A table does not tell the order of its bids: there
/// a bid must not exceed the most that its winner could ever bid for the task. A bid for what the
/// bidder cannot fly (core/auction/limits.hpp) is false whatever its height; in a table, for what
/// it could not fly alone.
class BidAudit {
 public:
  /// Share of a bundle's largest bid by which a bid may be off. Not for ties, which stay exact: it
  /// is for hosts whose exp() differs in the last bits.
  static constexpr double tolerance = 1e-9;

  /// `fleet`: the roster, ascending ids. All must outlive the audit.
  BidAudit(const TaskSet& set, const std::vector<Uav>& fleet, const AuctionSettings& settings,
           const Transit& transit);

  /// Why a statement, sound by itself (validation.hpp), is refused; none: its bids are true, or
  /// the mission does not ask for an audit. What is kept from call to call is its speed only.
  std::optional<std::string> refusal(const Statement& statement);

 private:
  std::optional<std::string> refusal(std::size_t author, const Claims& claims);
  std::optional<std::string> refusal(std::size_t author, const Table& table);
  std::size_t position(AgentId agent) const;
  const std::vector<double>& most(std::size_t member);

  const TaskSet& set_;
  const std::vector<Uav>& fleet_;
  const AuctionSettings& settings_;
  const Transit& transit_;
  std::vector<std::optional<BundleReplay>> replays_;  // by member; none: it has claimed nothing
  std::vector<std::vector<double>> most_;  // by member, then task; empty: in no table yet
};

}  // namespace arcbid
