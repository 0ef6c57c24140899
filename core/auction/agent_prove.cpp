// SPDX-License-Identifier: GPL-3.0-or-later
// The proof of agreement, and what it says.
#include <algorithm>
#include <utility>

#include "core/auction/agent.hpp"
#include "core/auction/roster.hpp"

namespace arcbid {

void Agent::prove(Update& update) {
  if (phase_ != Phase::auction || !readiness_.ready() || !policy_->agrees(view_)) return;
  Agreement agreement{view_hash_, round_, {}, {}, {}, {}};
  for (std::size_t k = 0; k < view_.roster().size(); ++k) {
    if (view_.dead(k)) continue;
    if (!readiness_.set()[k]) return;
    agreement.members.push_back(view_.roster()[k]);
  }
  agreement.winners = policy_->winners(view_);
  agreement.path = policy_->path();
  agreement.left = left_over(agreement);
  phase_ = Phase::agreed;
  status_is_news_ = true;
  update.agreed = std::move(agreement);
}

/// Claims come in the order in which they were taken, from which their path follows. Of tables only
/// the winners are known.
std::vector<NoBidder> Agent::left_over(const Agreement& agreement) const {
  const auto is_free = [](const Belief& belief) { return !belief.winner; };
  if (std::none_of(agreement.winners.begin(), agreement.winners.end(), is_free)) return {};
  std::vector<Winnings> members;
  for (const AgentId id : agreement.members) {
    Winnings& member =
        members.emplace_back(uav_of(*mission_, id), std::vector<TaskId>{}, std::nullopt);
    const auto* claims = std::get_if<Claims>(&view_.of(*view_.position(id)).body);
    for (std::uint32_t j = 0; !claims && j < agreement.winners.size(); ++j)
      if (agreement.winners[j].winner == id) member.taken.push_back({j});
    if (!claims) continue;
    for (const Claim& claim : claims->bundle) member.taken.push_back(claim.task);
    member.path = path_of(member.taken, tasks_, member.uav, mission_->auction, *transit_);
  }
  return no_bidders(members, tasks_, mission_->auction, *transit_);
}

}  // namespace arcbid
