// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/world/shrink.hpp"

#include <algorithm>

namespace arcbid {
namespace {

template <class Part>
void without_one(const WorldSpec& spec, std::vector<Part> FaultSchedule::*parts,
                 std::vector<WorldSpec>& out) {
  for (std::size_t n = 0; n < (spec.faults.*parts).size(); ++n) {
    out.push_back(spec);
    std::vector<Part>& left = out.back().faults.*parts;
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(n));
  }
}

WorldSpec without_agent(WorldSpec spec, std::size_t position) {
  std::vector<Uav>& fleet = spec.mission.fleet;
  const AgentId gone = fleet[position].id;
  fleet.erase(fleet.begin() + static_cast<std::ptrdiff_t>(position));
  std::erase_if(spec.faults.agents, [gone](const AgentFault& f) { return f.agent == gone; });
  return spec;
}

WorldSpec without_arc(WorldSpec spec, std::size_t position) {
  std::vector<Arc>& arcs = spec.mission.arcs;
  arcs.erase(arcs.begin() + static_cast<std::ptrdiff_t>(position));
  for (std::uint32_t m = 0; m < arcs.size(); ++m) arcs[m].id = {m};
  return spec;
}

}  // namespace

WorldSize size_of(const WorldSpec& spec) {
  const FaultSchedule& faults = spec.faults;
  return {faults.links.size() + faults.partitions.size() + faults.agents.size(),
          spec.mission.fleet.size(), spec.mission.arcs.size()};
}

std::vector<WorldSpec> smaller_worlds(const WorldSpec& spec) {
  std::vector<WorldSpec> out;
  without_one(spec, &FaultSchedule::agents, out);
  without_one(spec, &FaultSchedule::partitions, out);
  without_one(spec, &FaultSchedule::links, out);
  if (spec.mission.fleet.size() > 1)
    for (std::size_t k = 0; k < spec.mission.fleet.size(); ++k)
      out.push_back(without_agent(spec, k));
  if (spec.mission.arcs.size() > 1)
    for (std::size_t m = 0; m < spec.mission.arcs.size(); ++m) out.push_back(without_arc(spec, m));
  return out;
}

WorldSpec shrink(WorldSpec spec, const std::function<bool(const WorldSpec&)>& fails) {
  while (true) {
    std::vector<WorldSpec> smaller = smaller_worlds(spec);
    const auto still = std::find_if(smaller.begin(), smaller.end(), fails);
    if (still == smaller.end()) return spec;
    spec = std::move(*still);
  }
}

}  // namespace arcbid
