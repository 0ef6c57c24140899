// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/tour/costs.hpp"

namespace arcbid {

/// A node that another may be connected to, and the mean cost of that connection.
struct Neighbour {
  std::uint32_t node;
  double cost;
};

/// Of every node those it is worth connecting to, cheapest first: the nearest, and the nearest of
/// each octant, so that the way out of a cluster is among them. Memory: linear.
class Neighbours {
 public:
  /// Among `nodes` only, without a node's own arc. All points must be finite.
  Neighbours(const TourCosts& costs, std::span<const std::uint32_t> nodes);

  std::span<const Neighbour> of(std::uint32_t node) const {
    return {all_.data() + begin_[node], all_.data() + begin_[node + 1]};
  }

 private:
  std::vector<std::uint32_t> begin_;  // by node
  std::vector<Neighbour> all_;
};

}  // namespace arcbid
