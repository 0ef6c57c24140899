// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/replay/what_if.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.hpp"

namespace arcbid {
namespace {

bool is_in(const std::vector<Uav>& fleet, AgentId agent) {
  return std::any_of(fleet.begin(), fleet.end(),
                     [agent](const Uav& uav) { return uav.id == agent; });
}

/// What was to happen to those who are not there any more cannot happen.
void forget_the_absent(WorldSpec& world) {
  const std::vector<Uav>& fleet = world.mission.fleet;
  const auto absent = [&fleet](AgentId agent) { return !is_in(fleet, agent); };
  std::erase_if(world.faults.agents, [&](const AgentFault& fault) { return absent(fault.agent); });
  for (Partition& partition : world.faults.partitions)
    for (std::vector<AgentId>& group : partition.groups) std::erase_if(group, absent);
  std::erase_if(world.faults.links, [&](LinkFault& link) {
    const bool named = !link.from.empty(), named_to = !link.to.empty();
    std::erase_if(link.from, absent);
    std::erase_if(link.to, absent);
    return (named && link.from.empty()) || (named_to && link.to.empty());
  });
}

/// Whether somebody is there at the end.
bool anybody_lives(const WorldSpec& world) {
  return std::any_of(world.mission.fleet.begin(), world.mission.fleet.end(), [&](const Uav& uav) {
    return std::none_of(
        world.faults.agents.begin(), world.faults.agents.end(), [&](const AgentFault& fault) {
          return fault.agent == uav.id && fault.kind == AgentFaultKind::crash && !fault.for_ns;
        });
  });
}

void leave_out(const OtherRules& rules, std::vector<Uav>& fleet) {
  for (const AgentId agent : rules.without) {
    if (!is_in(fleet, agent))
      throw InputError(fmt::format("--without {}: is not of the run's fleet", agent.value));
    std::erase_if(fleet, [agent](const Uav& uav) { return uav.id == agent; });
  }
  if (rules.agents && *rules.agents > fleet.size())
    throw InputError(fmt::format("--agents {}: the run's fleet has {}; legal: 1 to that",
                                 *rules.agents, fleet.size()));
  if (rules.agents) fleet.resize(*rules.agents);
}

/// A loss that never ends leaves no calm in which an agreement must come. What ended before still
/// ends when it did.
void lose(double share, FaultSchedule& faults) {
  constexpr TimeNs lasts_ns = 10'000'000'000;
  const TimeNs ended_ns = faults.until_ns.value_or(INT64_MAX);
  for (LinkFault& link : faults.links) link.when.end_ns = std::min(link.when.end_ns, ended_ns);
  for (Partition& partition : faults.partitions)
    partition.when.end_ns = std::min(partition.when.end_ns, ended_ns);
  faults.until_ns = std::max(last_turn_ns(faults), faults.until_ns.value_or(0)) + lasts_ns;
  faults.links.emplace_back().loss = share;
}

}  // namespace

bool OtherRules::none() const {
  return !policy && !score && !agents && without.empty() && !bundle_limit && !loss;
}

WorldSpec under(const OtherRules& rules, WorldSpec world) {
  AuctionSettings& auction = world.mission.auction;
  if (rules.policy) auction.policy = *rules.policy;
  if (rules.score) auction.score = *rules.score;
  if (rules.bundle_limit) auction.bundle_limit = *rules.bundle_limit;
  leave_out(rules, world.mission.fleet);
  forget_the_absent(world);
  if (rules.loss && *rules.loss > 0) lose(*rules.loss, world.faults);
  if (world.mission.fleet.empty() || !anybody_lives(world))
    throw InputError("nobody would be alive at the end of this run: there is nothing to agree on");
  return world;
}

std::optional<WorldSpec> with_alive(WorldSpec world, AgentId agent, TimeNs declared_ns) {
  auto& faults = world.faults.agents;
  auto last = faults.end();
  for (auto fault = faults.begin(); fault != faults.end(); ++fault)
    if (fault->agent == agent && fault->kind == AgentFaultKind::crash &&
        fault->at_ns <= declared_ns && (last == faults.end() || fault->at_ns >= last->at_ns))
      last = fault;
  if (last == faults.end()) return std::nullopt;
  faults.erase(last);
  return world;
}

std::size_t owners_changed(const WorldResult& a, const WorldResult& b) {
  std::size_t changed = 0;
  for (std::size_t j = 0; j < std::max(a.winners.size(), b.winners.size()); ++j) {
    const auto of = [j](const WorldResult& result) {
      return j < result.winners.size() ? result.winners[j].winner : std::nullopt;
    };
    if (of(a) != of(b)) ++changed;
  }
  return changed;
}

}  // namespace arcbid
