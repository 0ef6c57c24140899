// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/world/fleet_graph.hpp"

#include <algorithm>
#include <map>

namespace arcbid {
namespace {

using HasLink = std::function<bool(std::size_t, std::size_t)>;

/// Breadth first: hops from `start` to everybody in reach.
std::map<std::size_t, std::size_t> hops_from(std::size_t start,
                                             const std::vector<std::size_t>& nodes,
                                             const HasLink& has_link) {
  std::map<std::size_t, std::size_t> hops{{start, 0}};
  std::vector<std::size_t> frontier{start};
  for (std::size_t n = 0; n < frontier.size(); ++n)
    for (const std::size_t node : nodes)
      if (!hops.contains(node) && has_link(frontier[n], node)) {
        hops[node] = hops[frontier[n]] + 1;
        frontier.push_back(node);
      }
  return hops;
}

}  // namespace

std::vector<Component> components(const std::vector<std::size_t>& nodes, const HasLink& has_link) {
  std::vector<Component> found;
  for (const std::size_t node : nodes) {
    const auto hops = hops_from(node, nodes, has_link);
    std::size_t furthest = 0;
    for (const auto& [other, distance] : hops) furthest = std::max(furthest, distance);
    const auto same = std::find_if(found.begin(), found.end(), [&](const Component& component) {
      return component.members.front() == hops.begin()->first;
    });
    if (same != found.end()) {
      same->diameter = std::max(same->diameter, furthest);
      continue;
    }
    Component component{.members = {}, .diameter = furthest};
    for (const auto& [member, distance] : hops) component.members.push_back(member);
    found.push_back(std::move(component));
  }
  return found;
}

}  // namespace arcbid
