// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/route/share.hpp"

#include <utility>

#include "core/auction/no_bidders.hpp"
#include "core/auction/roster.hpp"
#include "core/base/digest.hpp"

namespace arcbid {
namespace {

std::vector<std::optional<AgentId>> owners_of(const std::vector<Belief>& winners) {
  std::vector<std::optional<AgentId>> owners;
  for (const Belief& belief : winners) owners.push_back(belief.winner);
  return owners;
}

}  // namespace

FleetShare fleet_share(const Mission& mission, const TaskSet& set, const Agreement& agreement,
                       const Transit& transit, const StillWanted& wanted) {
  FleetShare share{agreement.members, {}, 0};
  if (mission.auction.trades == TradesKind::off) return share;
  std::vector<Uav> members;
  std::vector<std::vector<PathStop>> won;
  for (const Taken& taken : agreement.taken) {
    members.push_back(uav_of(mission, taken.agent));
    won.push_back(path_of(taken.tasks, set, members.back(), mission.auction, transit));
  }
  FleetPaths after = exchanged(mission, members, set, std::move(won), transit, wanted);
  if (!after.is_better) return share;
  share.paths = std::move(after.paths);
  share.exchanges = after.exchanges;
  return share;
}

Share share_of(const Mission& mission, const TaskSet& set, const Agreement& agreement, AgentId self,
               const Transit& transit, const StillWanted& wanted) {
  const FleetShare fleet = fleet_share(mission, set, agreement, transit, wanted);
  if (!fleet.is_better()) return {owners_of(agreement.winners), agreement.path, 0};
  Share share{std::vector<std::optional<AgentId>>(set.tasks.size()), {}, fleet.exchanges};
  for (std::size_t a = 0; a < fleet.members.size(); ++a) {
    for (const PathStop& stop : fleet.paths[a]) share.owners[stop.task.value] = fleet.members[a];
    if (fleet.members[a] == self) share.path = fleet.paths[a];
  }
  return share;
}

std::uint64_t digest(const std::vector<std::optional<AgentId>>& owners) {
  Digest d;
  for (const auto& owner : owners)
    d.add(std::uint64_t{owner.has_value()}).add(std::uint64_t{owner ? owner->value : 0});
  return d.value();
}

}  // namespace arcbid
