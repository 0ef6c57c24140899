// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tour/neighbours.hpp"

#include <algorithm>
#include <array>

#include "core/tour/kd_tree.hpp"

namespace arcbid {

namespace {

constexpr std::size_t kNearest = 6;
constexpr std::size_t kOfQuadrant = 2;  // where all is at one height
constexpr std::size_t kOfOctant = 1;

bool is_flat(const std::vector<Vec3>& points) {
  return std::ranges::all_of(points, [&](const Vec3& p) { return p.z() == points[0].z(); });
}

/// Cheapest first, each once.
void put_in_order(std::vector<Neighbour>& list) {
  std::ranges::sort(list, {}, &Neighbour::node);
  const auto twice = std::ranges::unique(list, {}, &Neighbour::node);
  list.erase(twice.begin(), twice.end());
  std::ranges::stable_sort(list, {}, &Neighbour::cost);
}

}  // namespace

Neighbours::Neighbours(const TourCosts& costs, std::span<const std::uint32_t> nodes)
    : begin_(costs.nodes() + 1, 0) {
  const std::vector<Vec3>& points = costs.points();
  const KdTree tree(points, nodes);
  const std::size_t of_octant = is_flat(points) ? kOfQuadrant : kOfOctant;
  std::vector<std::uint8_t> is_chosen(costs.nodes(), 0);
  for (const std::uint32_t node : nodes) is_chosen[node] = 1;

  std::array<KdTree::Found, kNearest> found;
  std::vector<Neighbour> list;
  for (std::uint32_t node = 0; node < costs.nodes(); ++node) {
    list.clear();
    for (unsigned octant = 0; is_chosen[node] && octant <= KdTree::everywhere; ++octant) {
      const auto wanted =
          std::span(found).first(octant == KdTree::everywhere ? kNearest : of_octant);
      tree.nearest(node, points[node], octant, wanted);
      for (const KdTree::Found& near : wanted)
        if (near.point != UINT32_MAX) list.push_back({near.point, costs.mean(node, near.point)});
    }
    put_in_order(list);
    all_.insert(all_.end(), list.begin(), list.end());
    begin_[node + 1] = static_cast<std::uint32_t>(all_.size());
  }
}

}  // namespace arcbid
