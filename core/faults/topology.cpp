// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/faults/fleet.hpp"
#include "core/faults/link_model.hpp"

namespace arcbid {
bool linked(const Topology& topology, const std::vector<Uav>& fleet, AgentId from, AgentId to) {
  const std::size_t a = position_of(fleet, from), b = position_of(fleet, to);
  const std::size_t apart = a < b ? b - a : a - b;
  if (apart == 0) return false;
  switch (topology.kind) {
    case TopologyKind::complete:
      return true;
    case TopologyKind::ring:
      return apart == 1 || apart + 1 == fleet.size();
    case TopologyKind::line:
      return apart == 1;
    case TopologyKind::star:
      return a == 0 || b == 0;
    case TopologyKind::geometric:
      return (fleet[a].home_m - fleet[b].home_m).norm() <= topology.radius_m;
  }
  return false;
}

}  // namespace arcbid
