// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/world/spec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/world/mission_maker.hpp"

namespace arcbid {
namespace {

/// By how much the clock may be ahead of the time at the fault's end. An agent's time stands still
/// until the time has caught up.
TimeNs ahead_ns(const AgentFault& fault) {
  const double drifted = fault.drift * static_cast<double>(fault.for_ns.value_or(0));
  return std::max<TimeNs>(0, fault.offset_ns + std::llround(drifted));
}

TimeNs end_ns(const AgentFault& fault) {
  const TimeNs end = fault.at_ns + fault.for_ns.value_or(0);
  return fault.kind == AgentFaultKind::clock ? end + ahead_ns(fault) : end;
}

}  // namespace

WorldSpec make_world(const WorldSettings& settings, std::uint64_t seed) {
  Dice dice(seed);
  WorldSpec spec{.seed = seed, .mission = {}, .faults = {}, .latency_ns = settings.latency_ns};
  spec.mission = make_mission(settings, seed, dice);
  spec.faults = make_faults(settings, spec.mission, seed, dice);
  return spec;
}

WorldSpec without_faults(WorldSpec spec) {
  spec.faults.links.clear();
  spec.faults.partitions.clear();
  spec.faults.agents.clear();
  return spec;
}

TimeNs calm_ns(const WorldSpec& spec) {
  const FaultSchedule& faults = spec.faults;
  TimeNs calm = faults.links.empty() && faults.partitions.empty() ? 0 : *faults.until_ns;
  for (const AgentFault& fault : faults.agents) calm = std::max(calm, end_ns(fault));
  return calm;
}

TimeNs last_turn_ns(const FaultSchedule& faults) {
  TimeNs last = 0;
  const auto turn = [&](TimeNs t) {
    if (t < faults.until_ns.value_or(INT64_MAX)) last = std::max(last, t);
  };
  for (const LinkFault& fault : faults.links) {
    const bool lasting = fault.cut || fault.clog || !fault.obstacles.empty() || fault.reach;
    if (lasting) last = std::max(last, faults.until_ns.value_or(0));
    turn(fault.when.start_ns);
    turn(fault.when.end_ns);
  }
  if (!faults.partitions.empty()) last = std::max(last, faults.until_ns.value_or(0));
  for (const AgentFault& fault : faults.agents) last = std::max(last, end_ns(fault));
  return last;
}

std::string summary(const WorldSpec& spec) {
  const AuctionSettings& auction = spec.mission.auction;
  const FaultSchedule& faults = spec.faults;
  return fmt::format(
      "{} agents, {} arcs, {}, {}, {}; {} link faults, {} partitions, {} agent faults",
      spec.mission.fleet.size(), spec.mission.arcs.size(), name_of(auction.policy),
      name_of(auction.score), topology_names[static_cast<std::size_t>(faults.topology.kind)],
      faults.links.size(), faults.partitions.size(), faults.agents.size());
}

}  // namespace arcbid
