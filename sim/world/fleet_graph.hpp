// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace arcbid {

/// Agents that can reach each other over links between them, and how far apart they are.
struct Component {
  std::vector<std::size_t> members;  ///< positions, ascending
  std::size_t diameter = 0;          ///< hops between the two furthest
};

/// The components of the graph over `nodes`; links go both ways.
std::vector<Component> components(const std::vector<std::size_t>& nodes,
                                  const std::function<bool(std::size_t, std::size_t)>& has_link);

}  // namespace arcbid
