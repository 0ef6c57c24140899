// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/world/script.hpp"

#include <algorithm>

namespace arcbid {
namespace {

void add(const AgentFault& fault, std::size_t agent, std::vector<Act>& script) {
  using Kind = Act::Kind;
  const auto act = [&](TimeNs at_ns, Kind kind) {
    script.push_back({at_ns, kind, agent, fault.malformation, fault.count});
  };
  const auto from_to = [&](Kind begin, Kind end) {
    act(fault.at_ns, begin);
    if (fault.for_ns) act(fault.at_ns + *fault.for_ns, end);
  };
  switch (fault.kind) {
    case AgentFaultKind::crash:
      return from_to(Kind::crash, Kind::start);
    case AgentFaultKind::pause:
      return from_to(Kind::pause, Kind::resume);
    case AgentFaultKind::twin:
      return from_to(Kind::twin_start, Kind::twin_stop);
    case AgentFaultKind::malformed:
      return act(fault.at_ns,
                 fault.malformation == Malformation::over_bid ? Kind::over_bid : Kind::malform);
    case AgentFaultKind::late:   // its start is told below
    case AgentFaultKind::clock:  // the clock is asked for at every step
      return;
  }
}

}  // namespace

std::vector<Act> script_of(const WorldSpec& spec) {
  std::vector<Act> script;
  const std::vector<Uav>& fleet = spec.mission.fleet;
  for (std::size_t k = 0; k < fleet.size(); ++k) {
    Act start{.agent = k};
    for (const AgentFault& fault : spec.faults.agents)
      if (fault.agent == fleet[k].id && fault.kind == AgentFaultKind::late)
        start.at_ns = fault.for_ns.value_or(INT64_MAX);
    script.push_back(start);
  }
  for (const AgentFault& fault : spec.faults.agents)
    for (std::size_t k = 0; k < fleet.size(); ++k)
      if (fleet[k].id == fault.agent) add(fault, k, script);
  std::stable_sort(script.begin(), script.end(),
                   [](const Act& a, const Act& b) { return a.at_ns < b.at_ns; });
  return script;
}

}  // namespace arcbid
