// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/world/checkers/exchanges.hpp"

#include <algorithm>

#include "sim/world/checkers/greedy.hpp"

namespace arcbid {

bool ExchangeChecker::wants(const Agreement& proof) const {
  const auto found = worked_out_.find(proof.view_hash);
  return mission_.auction.trades != TradesKind::off &&
         (found == worked_out_.end() || found->second.times < 2);
}

void ExchangeChecker::check_owners(TimeNs now_ns, const Agreement& proof, const FleetShare& share) {
  std::vector<int> flown(pieces_.size());
  for (const auto& path : share.paths)
    for (const PathStop& stop : path) ++flown.at(stop.task.value);
  for (std::size_t j = 0; j < flown.size(); ++j)
    if (flown[j] != (proof.winners[j].winner ? 1 : 0))
      findings_.add(now_ns, "exchanges", "task {} is flown by {} after exchanges", j, flown[j]);
}

void ExchangeChecker::check_limits(TimeNs now_ns, const FleetShare& share) {
  const std::uint32_t limit = mission_.auction.bundle_limit;
  for (std::size_t a = 0; a < share.members.size(); ++a) {
    const auto uav = std::ranges::find(mission_.fleet, share.members[a], &Uav::id);
    const std::uint32_t id = uav->id.value;
    const auto& path = share.paths[a];
    if (limit > 0 && path.size() > limit)
      findings_.add(now_ns, "exchanges", "agent {} flies {} tasks, its limit is {}", id,
                    path.size(), limit);
    const double time_s = closed_path_s(pieces_, *uav, path, transit_);
    if (uav->endurance_s && time_s > *uav->endurance_s * (1 + 1e-9))
      findings_.add(now_ns, "exchanges", "agent {} flies {} s, its endurance is {}", id, time_s,
                    *uav->endurance_s);
    for (const PathStop& stop : path)
      if (!serves(uav->payload, mission_.arcs[pieces_[stop.task.value].arc].payload))
        findings_.add(now_ns, "exchanges", "agent {} has no payload for task {}", id,
                      stop.task.value);
  }
}

void ExchangeChecker::compare(TimeNs now_ns, double won_s, double flown_s) {
  // Of other policies it is not known in which order a path grew.
  if (mission_.auction.policy == PolicyKind::claims && flown_s > won_s * (1 + 1e-9))
    findings_.add(now_ns, "exchanges", "the slowest takes {} s after exchanges, {} s before",
                  flown_s, won_s);
}

void ExchangeChecker::after(TimeNs now_ns, const Agreement& proof, const FleetShare& share) {
  WorkedOut& before = worked_out_[proof.view_hash];
  if (before.times++ > 0 && before.paths != share.paths)
    findings_.add(now_ns, "exchanges", "two who agreed under {:016x} exchange differently",
                  proof.view_hash);
  before.paths = share.paths;
  if (!share.is_better()) return;
  check_owners(now_ns, proof, share);
  check_limits(now_ns, share);
}

}  // namespace arcbid
