// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/airspace/exact.hpp"
#include "core/airspace/free_grid.hpp"

namespace arcbid {

/// Places twice as close as a grid's cells, eight in each, and steps between them that are checked
/// against the surface itself: for searches where no cell is free.
class FineLattice {
 public:
  using Index = std::array<std::int64_t, 3>;
  struct Node {
    Vec3 at;
    double clear_m;      ///< distance from the surface
    std::uint32_t from;  ///< itself where the search began
    double length_m = std::numeric_limits<double>::infinity();
    bool settled = false;
  };

  FineLattice(const FreeGrid& grid, const ExactClearance& clearance)
      : grid_(grid),
        clearance_(clearance),
        required_m_(clearance.required_m()),
        step_m_(grid.cell_m() / 2) {}

  double step_m() const { return step_m_; }
  double required_m() const { return required_m_; }
  Index index(const Vec3& p) const {
    Index out{};
    for (int axis = 0; axis < 3; ++axis)
      out[static_cast<std::size_t>(axis)] =
          static_cast<std::int64_t>(std::floor((p[axis] - grid_.low_m()[axis]) / step_m_));
    return out;
  }
  Vec3 place(const Index& i) const {
    return grid_.low_m() + step_m_ * Vec3(static_cast<double>(i[0]) + 0.5,
                                          static_cast<double>(i[1]) + 0.5,
                                          static_cast<double>(i[2]) + 0.5);
  }
  double clear_m(const Vec3& p) const { return clearance_.distance_m(p); }

  template <class Visit>
  void for_around(const Vec3& p, Visit visit) const {
    const Index here = index(p);
    for (int k = 0; k < 27; ++k)
      visit(Index{here[0] + k % 3 - 1, here[1] + k / 3 % 3 - 1, here[2] + k / 9 - 1});
  }

  /// A distance is 1-Lipschitz, so those of both ends settle nearly all steps.
  bool clears(const Node& a, const Vec3& b, double b_clear_m) const {
    if (b_clear_m < required_m_) return false;
    if ((a.clear_m + b_clear_m - (b - a.at).norm()) / 2 >= required_m_) return true;
    return clearance_.clears(a.at, b);
  }

  /// The way, from its first place on, without the bends that can be cut off.
  std::vector<AccessPoint> shortened(const std::vector<Vec3>& way) const {
    std::vector<AccessPoint> out{{way.front()}};
    for (std::size_t k = 0; k + 1 < way.size();) {
      std::size_t next = way.size() - 1;
      while (next > k + 1 && !clearance_.clears(way[k], way[next])) --next;
      out.push_back({way[next]});
      k = next;
    }
    return out;
  }

 private:
  const FreeGrid& grid_;
  const ExactClearance& clearance_;
  double required_m_, step_m_;
};

}  // namespace arcbid
