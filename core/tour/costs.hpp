// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "core/arcs/arc.hpp"
#include "core/tour/tour.hpp"

namespace arcbid {

/// What connections cost, in metres. Node 2a is the first end of arc a, node 2a + 1 the last; home
/// is one more arc, after the others, with both ends in one place.
class TourCosts {
 public:
  /// `transit` must outlive this. Straight legs are worked out when asked for; of other transits up
  /// to `most_tabulated` nodes a table is made, and beyond that the transit is asked each time.
  TourCosts(std::span<const TourArc> arcs, const Vec3& home_m, const Transit& transit,
            std::size_t most_tabulated = 2000);

  std::size_t nodes() const { return points_.size(); }
  const std::vector<Vec3>& points() const { return points_; }

  /// Whether every leg costs the same there and back, as far as a table or a sample can tell.
  bool is_symmetric() const { return is_symmetric_; }

  /// From node u to node v.
  double directed(std::uint32_t u, std::uint32_t v) const {
    if (is_straight_) return straight(u, v);
    return table_.empty() ? transit_.length_m(points_[u], points_[v]) : table_[u * nodes() + v];
  }
  /// The mean of there and back.
  double mean(std::uint32_t u, std::uint32_t v) const {
    return is_symmetric_ ? directed(u, v) : 0.5 * (directed(u, v) + directed(v, u));
  }
  /// What the way there costs more than the mean; the way back costs as much less.
  double excess(std::uint32_t u, std::uint32_t v) const {
    return 0.5 * (directed(u, v) - directed(v, u));
  }

 private:
  double straight(std::uint32_t u, std::uint32_t v) const {
    const Vec3 &a = points_[u], &b = points_[v];
    const double x = a.x() - b.x(), y = a.y() - b.y(), z = a.z() - b.z();
    return std::sqrt(x * x + y * y + z * z);
  }
  void tabulate();
  bool sampled_symmetric() const;

  const Transit& transit_;
  std::vector<Vec3> points_;
  std::vector<double> table_;  // from, to
  bool is_straight_, is_symmetric_ = true;
};

}  // namespace arcbid
