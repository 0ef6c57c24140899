// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/arcs/mission.hpp"
#include "core/base/error.hpp"

namespace arcbid {

/// The position of an agent that is in the fleet.
inline std::size_t position_of(const std::vector<Uav>& fleet, AgentId agent) {
  const auto found =
      std::find_if(fleet.begin(), fleet.end(), [&](const Uav& uav) { return uav.id == agent; });
  check(found != fleet.end(), "both ends of a link are in the fleet");
  return static_cast<std::size_t>(found - fleet.begin());
}

}  // namespace arcbid
