// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/auction/bid_audit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"

namespace arcbid {
namespace {

std::string cannot_fly(AgentId agent, TaskId task) {
  return fmt::format(
      "agent {} bids for task {}, for which it has not the payload or, after what it bid for "
      "before, not the endurance",
      agent.value, task.value);
}

}  // namespace

BidAudit::BidAudit(const TaskSet& set, const std::vector<Uav>& fleet,
                   const AuctionSettings& settings, const Transit& transit)
    : set_(set),
      fleet_(fleet),
      settings_(settings),
      transit_(transit),
      replays_(fleet.size()),
      most_(fleet.size()) {}

std::size_t BidAudit::position(AgentId agent) const {
  const auto at = std::lower_bound(fleet_.begin(), fleet_.end(), agent,
                                   [](const Uav& uav, AgentId id) { return uav.id < id; });
  check(at != fleet_.end() && at->id == agent, "whose bids are audited is of the fleet");
  return static_cast<std::size_t>(at - fleet_.begin());
}

std::optional<std::string> BidAudit::refusal(const Statement& statement) {
  if (!settings_.audit_bids || statement.key.dead) return {};
  const std::size_t author = position(statement.agent);
  return std::visit([&](const auto& body) { return refusal(author, body); }, statement.body);
}

/// What the last claims of this author have in common with these is not computed again.
std::optional<std::string> BidAudit::refusal(std::size_t author, const Claims& claims) {
  const std::vector<Claim>& bundle = claims.bundle;
  if (bundle.empty()) return {};
  if (!replays_[author]) replays_[author] = make_replay(set_, fleet_[author], settings_, transit_);
  BundleReplay& replay = *replays_[author];
  const auto same =
      std::mismatch(bundle.begin(), bundle.end(), replay.claims().begin(), replay.claims().end(),
                    [](const Claim& a, const Claim& b) { return a.task == b.task; });
  const auto kept = static_cast<std::size_t>(same.first - bundle.begin());
  if (kept < bundle.size()) replay.keep(kept);
  double largest = 0;
  for (std::size_t n = 0; n < bundle.size(); ++n) {
    const Claim& stated = bundle[n];
    const double allowed = n < kept ? replay.claims()[n].bid : replay.bid(stated.task);
    if (allowed == unflyable) return cannot_fly(fleet_[author].id, stated.task);
    largest = std::max(largest, std::abs(allowed));
    // Not "greater": a bid that comes to NaN allows nothing.
    if (!(std::abs(stated.bid - allowed) <= tolerance * largest))
      return fmt::format("agent {} bids {} for task {}, where its path allows {}",
                         fleet_[author].id.value, stated.bid, stated.task.value, allowed);
    if (n >= kept) replay.take(stated.task);
  }
  return {};
}

/// By diminishing gains nothing is bid that exceeds the bid with an empty path. That also holds
/// where tasks are inserted into a discounted path: none is worth more than flown to directly. For
/// MiniSum a detour already flown makes a task cheaper; but the bundle's first bid was made with an
/// empty path, and warped bids never rise above it. What a UAV cannot fly alone it cannot fly with
/// more.
const std::vector<double>& BidAudit::most(std::size_t member) {
  std::vector<double>& most = most_[member];
  if (!most.empty()) return most;
  const auto score = make_score(set_, fleet_[member], settings_, transit_);
  for (const Task& task : set_.tasks) most.push_back(score->best(task.id).gain);
  if (settings_.score == ScoreKind::minisum) {
    const double first = *std::max_element(most.begin(), most.end());
    for (double& bid : most)
      if (bid > unflyable) bid = first;
  }
  return most;
}

std::optional<std::string> BidAudit::refusal(std::size_t author, const Table& table) {
  for (std::size_t j = 0; j < table.beliefs.size(); ++j) {
    const Belief& belief = table.beliefs[j];
    if (!belief.winner) continue;
    const double allowed = most(position(*belief.winner))[j];
    if (allowed == unflyable) return cannot_fly(*belief.winner, {static_cast<std::uint32_t>(j)});
    if (!(belief.bid - allowed <= tolerance * std::abs(allowed)))
      return fmt::format("agent {} believes that agent {} bid {} for task {}, at most {} is true",
                         fleet_[author].id.value, belief.winner->value, belief.bid, j, allowed);
  }
  return {};
}

}  // namespace arcbid
