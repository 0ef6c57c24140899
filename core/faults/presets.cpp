// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/faults/presets.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <functional>

#include "core/base/error.hpp"

namespace arcbid {
namespace {

using Ids = std::vector<AgentId>;

TimeNs seconds(double s) {
  return static_cast<TimeNs>(s * 1e9);
}

Window between(double from_s, double to_s) {
  return {seconds(from_s), seconds(to_s)};
}

FaultSchedule of_links(const LinkFault& fault) {
  FaultSchedule schedule;
  schedule.links = {fault};
  return schedule;
}

FaultSchedule lossy(double loss) {
  LinkFault fault;
  fault.loss = loss;
  return of_links(fault);
}

FaultSchedule bursty() {
  LinkFault fault;
  fault.burst = Burst{};
  return of_links(fault);
}

FaultSchedule delayed() {
  LinkFault fault;
  fault.delay = Delay{Delay::Kind::exponential, seconds(0.005), 0, seconds(0.1)};
  return of_links(fault);
}

FaultSchedule slow_link() {
  LinkFault fault;
  fault.capacity = Capacity{32'000, 16'000};
  return of_links(fault);
}

FaultSchedule duplicates() {
  LinkFault fault;
  fault.delay = Delay{Delay::Kind::uniform, 0, seconds(0.05), 0};
  fault.duplicate = 0.3;
  fault.stale = 0.1;
  fault.stale_ns = seconds(2);
  return of_links(fault);
}

FaultSchedule clogged() {
  LinkFault fault;
  fault.clog = true;
  fault.when = between(1, 2.5);
  return of_links(fault);
}

FaultSchedule one_way(const Ids& fleet) {
  LinkFault fault;
  fault.from = {fleet.back()};
  fault.cut = true;
  fault.when = between(1, 4);
  return of_links(fault);
}

/// The fleet in `parts` runs of neighbours, as even as can be; no part is empty.
std::vector<Ids> parts_of(const Ids& fleet, std::size_t parts) {
  std::vector<Ids> groups;
  for (std::size_t i = 0; i < parts; ++i) {
    const auto start = static_cast<std::ptrdiff_t>(fleet.size() * i / parts),
               end = static_cast<std::ptrdiff_t>(fleet.size() * (i + 1) / parts);
    if (start < end) groups.emplace_back(fleet.begin() + start, fleet.begin() + end);
  }
  return groups;
}

FaultSchedule parted(const std::vector<Ids>& groups, const Window& when, TimeNs flap_ns = 0) {
  FaultSchedule schedule;
  schedule.partitions = {{groups, when, flap_ns}};
  return schedule;
}

FaultSchedule isolate_one(const Ids& fleet) {
  const Ids others(fleet.begin(), fleet.end() - 1);
  return parted(others.empty() ? std::vector<Ids>{fleet} : std::vector<Ids>{others}, between(1, 4));
}

FaultSchedule heal_in_steps(const Ids& fleet) {
  std::vector<Ids> thirds = parts_of(fleet, 3);
  FaultSchedule schedule = parted(thirds, between(1, 2.5));
  if (thirds.size() > 1) {
    thirds[0].insert(thirds[0].end(), thirds[1].begin(), thirds[1].end());
    thirds.erase(thirds.begin() + 1);
  }
  schedule.partitions.push_back({thirds, between(2.5, 4), 0});
  return schedule;
}

AgentFault agent_fault(AgentId agent, AgentFaultKind kind, double at_s,
                       std::optional<double> for_s) {
  AgentFault fault;
  fault.agent = agent;
  fault.kind = kind;
  fault.at_ns = seconds(at_s);
  if (for_s) fault.for_ns = seconds(*for_s);
  return fault;
}

FaultSchedule of_agent(AgentId agent, AgentFaultKind kind, double at_s,
                       std::optional<double> for_s) {
  FaultSchedule schedule;
  schedule.agents = {agent_fault(agent, kind, at_s, for_s)};
  return schedule;
}

FaultSchedule clock_skew(const Ids& fleet) {
  FaultSchedule schedule;
  AgentFault ahead = agent_fault(fleet.front(), AgentFaultKind::clock, 0, {});
  ahead.offset_ns = seconds(30);
  ahead.drift = 0.001;
  AgentFault step_back = agent_fault(fleet.back(), AgentFaultKind::clock, 2, {});
  step_back.offset_ns = -seconds(5);
  schedule.agents = {ahead, step_back};
  return schedule;
}

FaultSchedule malformed(const Ids& fleet, const std::vector<Malformation>& malformations) {
  FaultSchedule schedule;
  double at_s = 1;
  for (const Malformation malformation : malformations) {
    AgentFault fault = agent_fault(fleet.back(), AgentFaultKind::malformed, at_s, {});
    fault.malformation = malformation;
    fault.count = 10;
    schedule.agents.push_back(fault);
    at_s += 0.2;
  }
  return schedule;
}

FaultSchedule of_topology(TopologyKind kind) {
  FaultSchedule schedule;
  schedule.topology.kind = kind;
  return schedule;
}

FaultSchedule storm(const Ids& fleet) {
  FaultSchedule schedule = bursty();
  schedule.until_ns = seconds(30);
  schedule.partitions = parted(parts_of(fleet, 2), between(1, 3)).partitions;
  schedule.agents = {agent_fault(fleet[0], AgentFaultKind::crash, 1.5, 2),
                     agent_fault(fleet[2], AgentFaultKind::crash, 2.5, {}),
                     agent_fault(fleet[1], AgentFaultKind::pause, 3.5, 1)};
  return schedule;
}

struct Entry {
  FaultPreset preset;
  std::size_t least_agents;
  std::function<FaultSchedule(const Ids&)> make;
};

std::vector<Entry> all_entries() {
  using K = AgentFaultKind;
  using M = Malformation;
  return {
      {{"lossy_10", "Every link loses 10 % of its messages, each by itself."},
       1,
       [](const Ids&) { return lossy(0.1); }},
      {{"lossy_30", "Every link loses 30 %."}, 1, [](const Ids&) { return lossy(0.3); }},
      {{"lossy_80", "Every link loses 80 %."}, 1, [](const Ids&) { return lossy(0.8); }},
      {{"bursty", "Every link loses 30 %, in bursts of 8 messages on average (Gilbert-Elliott)."},
       1,
       [](const Ids&) { return bursty(); }},
      {{"split_brain", "The fleet falls into two halves from 1 s to 3 s, then heals."},
       2,
       [](const Ids& ids) { return parted(parts_of(ids, 2), between(1, 3)); }},
      {{"isolate_one", "The last agent is cut off from 1 s to 4 s."}, 2, isolate_one},
      {{"heal_in_steps", "Three parts from 1 s; the first two meet at 2.5 s, all at 4 s."},
       3,
       heal_in_steps},
      {{"flapping", "The two halves lose and find each other every 0.5 s from 1 s to 6 s."},
       2,
       [](const Ids& ids) { return parted(parts_of(ids, 2), between(1, 6), seconds(0.5)); }},
      {{"one_way", "The last agent hears all, but nobody hears it, from 1 s to 4 s."}, 2, one_way},
      {{"slow_link", "Every link carries 32 kB/s, behind a queue of 16 kB."},
       1,
       [](const Ids&) { return slow_link(); }},
      {{"delayed",
        "Every message takes 5 ms and an exponential 100 ms more; many overtake others."},
       1,
       [](const Ids&) { return delayed(); }},
      {{"duplicates", "30 % come twice, 10 % again after 2 s, all up to 50 ms late."},
       1,
       [](const Ids&) { return duplicates(); }},
      {{"clogged", "Nothing arrives from 1 s to 2.5 s; then all of it at once."},
       1,
       [](const Ids&) { return clogged(); }},
      {{"crash_restart", "The last agent is killed at 1.5 s and started again 2 s later."},
       1,
       [](const Ids& ids) { return of_agent(ids.back(), K::crash, 1.5, 2); }},
      {{"crash", "The last agent is killed at 1.5 s for good."},
       2,
       [](const Ids& ids) { return of_agent(ids.back(), K::crash, 1.5, {}); }},
      {{"coordinator_crash", "The coordinator is killed at 2 s for good."},
       1,
       [](const Ids&) { return of_agent({0}, K::crash, 2, {}); }},
      {{"pause", "The last agent is stopped at 1.5 s and goes on 3 s later."},
       1,
       [](const Ids& ids) { return of_agent(ids.back(), K::pause, 1.5, 3); }},
      {{"late_join", "The last agent starts 3 s after the others."},
       1,
       [](const Ids& ids) { return of_agent(ids.back(), K::late, 0, 3); }},
      {{"clock_skew",
        "The first agent's clock is 30 s ahead and gains 1 ms a second; the last "
        "one's steps back by 5 s at 2 s."},
       1,
       clock_skew},
      {{"twin", "A second process with the last agent's id runs from 1 s to 3 s."},
       1,
       [](const Ids& ids) { return of_agent(ids.back(), K::twin, 1, 2); }},
      {{"malformed", "From 1 s on, the last agent sends everything that must be refused."},
       1,
       [](const Ids& ids) {
         return malformed(ids, {M::nan_bid, M::unknown_task, M::unknown_agent, M::wrong_mission,
                                M::wrong_tasks, M::replay});
       }},
      {{"over_bidder", "At 1 s the last agent claims every task with bids above anybody's."},
       2,
       [](const Ids& ids) { return malformed(ids, {M::over_bid}); }},
      {{"ring", "Each agent hears its two neighbours only."},
       1,
       [](const Ids&) { return of_topology(TopologyKind::ring); }},
      {{"line", "A chain: the ends hear one neighbour, the others two."},
       1,
       [](const Ids&) { return of_topology(TopologyKind::line); }},
      {{"star", "All agents hear the first one, and it hears all."},
       1,
       [](const Ids&) { return of_topology(TopologyKind::star); }},
      {{"storm",
        "Bursts of 30 % on every link, two halves from 1 s to 3 s, two agents killed of "
        "which one comes back, one paused for 1 s; links are well from 30 s on."},
       4,
       storm},
  };
}

const std::vector<Entry>& entries() {
  static const std::vector<Entry> all = all_entries();
  return all;
}

}  // namespace

const std::vector<FaultPreset>& fault_presets() {
  static const std::vector<FaultPreset> presets = [] {
    std::vector<FaultPreset> list;
    for (const Entry& entry : entries()) list.push_back(entry.preset);
    return list;
  }();
  return presets;
}

FaultSchedule preset(const std::string& name, const std::vector<AgentId>& fleet) {
  check(!fleet.empty(), "a fleet has agents");
  for (const Entry& entry : entries()) {
    if (entry.preset.name != name) continue;
    if (fleet.size() < entry.least_agents)
      throw InputError(fmt::format("fault preset {}: the fleet has {} agent{}; it takes {}", name,
                                   fleet.size(), fleet.size() == 1 ? "" : "s", entry.least_agents));
    FaultSchedule schedule = entry.make(fleet);
    schedule.name = name;
    return schedule;
  }
  std::vector<std::string> names;
  for (const FaultPreset& p : fault_presets()) names.push_back(p.name);
  throw InputError(
      fmt::format("fault preset {}: unknown; legal: {}", name, fmt::join(names, ", ")));
}

}  // namespace arcbid
