// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/trades/allocation.hpp"

namespace arcbid {

/// An end point: 2 * lot is its first point, 2 * lot + 1 its last. Homes come after all lots, two
/// numbers each, so that a home looks like a lot without length.
using Node = std::uint32_t;

/// Lengths of the legs between all end points, and which of them are near each other. Where a leg
/// and its way back differ, the mean of both: what is searched with may be flown in either sense.
class Legs {
 public:
  /// `neighbours`: how many near nodes are kept for each.
  Legs(const std::vector<Trader>& traders, const std::vector<Lot>& lots, const Transit& transit,
       std::size_t neighbours);

  float length_m(Node from, Node to) const { return lengths_m_[from * nodes_ + to]; }
  /// End points of other lots, the nearest first; fewer where there are not so many.
  std::span<const Node> near(Node node) const { return {near_.data() + node * kept_, kept_}; }

 private:
  void level();
  void keep_near(std::size_t lots);

  std::size_t nodes_, kept_;
  std::vector<float> lengths_m_;
  std::vector<Node> near_;
};

}  // namespace arcbid
