// SPDX-License-Identifier: GPL-3.0-or-later
// The proof of agreement, and what it says.
#include <algorithm>
#include <functional>
#include <utility>

#include "core/auction/agent.hpp"
#include "core/auction/roster.hpp"

namespace arcbid {

void Agent::prove(Update& update) {
  if (phase_ != Phase::auction || !readiness_.ready() || !policy_->agrees(view_)) return;
  Agreement agreement{view_hash_, round_, {}, {}, {}, {}, {}};
  for (std::size_t k = 0; k < view_.roster().size(); ++k) {
    if (view_.dead(k)) continue;
    if (!readiness_.set()[k]) return;
    agreement.members.push_back(view_.roster()[k]);
  }
  agreement.winners = policy_->winners(view_);
  agreement.path = policy_->path();
  for (const AgentId member : agreement.members)
    agreement.taken.push_back(taken_by(member, agreement.winners));
  agreement.left = left_over(agreement);
  phase_ = Phase::agreed;
  status_is_news_ = true;
  update.agreed = std::move(agreement);
}

Taken Agent::taken_by(AgentId agent, const std::vector<Belief>& winners) const {
  Taken out{agent, {}};
  if (const auto* claims = std::get_if<Claims>(&view_.of(*view_.position(agent)).body)) {
    for (const Claim& claim : claims->bundle) out.tasks.push_back(claim.task);
    return out;
  }
  for (std::uint32_t j = 0; j < winners.size(); ++j)
    if (winners[j].winner == agent) out.tasks.push_back({j});
  std::ranges::stable_sort(out.tasks, std::greater(),
                           [&](TaskId task) { return winners[task.value].bid; });
  return out;
}

std::vector<NoBidder> Agent::left_over(const Agreement& agreement) const {
  const auto is_free = [](const Belief& belief) { return !belief.winner; };
  if (std::ranges::none_of(agreement.winners, is_free)) return {};
  std::vector<Winnings> members;
  for (const Taken& taken : agreement.taken) {
    const Uav& uav = uav_of(*mission_, taken.agent);
    Winnings& member = members.emplace_back(uav, taken.tasks, std::nullopt);
    if (states_claims(mission_->auction.policy))
      member.path = path_of(taken.tasks, tasks_, uav, mission_->auction, *transit_);
  }
  return no_bidders(members, tasks_, mission_->auction, *transit_);
}

}  // namespace arcbid
