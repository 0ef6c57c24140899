// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/arcs/arc.hpp"

namespace arcbid {

/// Finds the nearest of a set of points, also within one octant around the place asked for.
class KdTree {
 public:
  struct Found {
    double squared_m = std::numeric_limits<double>::infinity();
    std::uint32_t point = UINT32_MAX;
  };
  /// The octants are 0 to 7: bit a is set where a point's coordinate a is not below the place's.
  static constexpr unsigned everywhere = 8;

  /// Of `points` those that `chosen` names. Keeps a copy. All must be finite.
  KdTree(std::span<const Vec3> points, std::span<const std::uint32_t> chosen);

  /// The nearest to points[from] within `octant` that belong to another pair (2a, 2a + 1), nearest
  /// first, as many as `found` has room for; those not there have no point. Ties: the one found
  /// first, which depends on nothing but the points.
  void nearest(std::uint32_t from, const Vec3& at, unsigned octant, std::span<Found> found) const;

 private:
  struct Cell {
    std::array<double, 3> low, high;
    std::uint32_t begin, end;  // of items_
    std::uint32_t upper = 0;   // child; the lower one follows its parent. 0: a leaf
  };
  struct Item {
    std::array<double, 3> at;
    std::uint32_t point;
  };
  struct Query {
    std::array<double, 3> at;
    std::uint32_t pair;
    unsigned octant;
    std::span<Found> found;
  };

  void build(std::uint32_t begin, std::uint32_t end);
  void search(std::uint32_t cell, const Query& query) const;
  static double least_squared_m(const Cell& cell, const Query& query);
  static void offer(const Item& item, const Query& query);

  std::vector<Cell> cells_;
  std::vector<Item> items_;
};

}  // namespace arcbid
