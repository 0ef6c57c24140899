// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/replay/run_exchanges.hpp"

#include <ranges>

#include "core/route/make_transit.hpp"
#include "core/route/share.hpp"

namespace arcbid {

RunExchanges::RunExchanges(const RunArchive& run) : run_(run) {
  if (run.mission->auction.trades != TradesKind::off) transit_ = make_transit(*run.mission);
}

/// Tasks without an owner stay so, and nothing is exchanged of them: id 0, which nobody has.
std::vector<AgentId> RunExchanges::worked_out(const Agreement& agreement) const {
  const FleetShare share = fleet_share(*run_.mission, run_.tasks, agreement, *transit_);
  if (!share.is_better()) return {};
  std::vector<AgentId> owners(run_.tasks.tasks.size(), AgentId{0});
  for (std::size_t a = 0; a < share.members.size(); ++a)
    for (const PathStop& stop : share.paths[a]) owners[stop.task.value] = share.members[a];
  return owners;
}

const std::vector<AgentId>* RunExchanges::owners(const Agreement& agreement) {
  if (!transit_ || agreement.winners.size() != run_.tasks.tasks.size()) return nullptr;
  auto found = owners_.find(agreement.view_hash);
  if (found == owners_.end())
    found = owners_.emplace(agreement.view_hash, worked_out(agreement)).first;
  return found->second.empty() ? nullptr : &found->second;
}

std::optional<Agreement> last_agreement(const RunArchive& run, const Playback& playback) {
  for (const Moment& moment : playback.moments() | std::views::reverse) {
    const LifeLog& life = run.lives[moment.life];
    if (life.marks()[moment.mark].agreed) return life.step(moment.mark).update.agreed;
  }
  return std::nullopt;
}

}  // namespace arcbid
