// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tour/costs.hpp"

#include <algorithm>
#include <typeinfo>

namespace arcbid {

namespace {

/// Tables of searched ways differ by rounding between there and back.
bool equal(double there, double back) {
  return std::abs(there - back) <= 1e-9 * (std::abs(there) + std::abs(back));
}

}  // namespace

TourCosts::TourCosts(std::span<const TourArc> arcs, const Vec3& home_m, const Transit& transit,
                     std::size_t most_tabulated)
    // A class derived from StraightTransit may cost more than its legs are long.
    : transit_(transit), is_straight_(typeid(transit) == typeid(StraightTransit)) {
  points_.reserve(2 * arcs.size() + 2);
  for (const TourArc& arc : arcs) {
    points_.push_back(arc.first_m);
    points_.push_back(arc.last_m);
  }
  points_.insert(points_.end(), 2, home_m);
  if (is_straight_) return;
  if (nodes() <= most_tabulated) tabulate();
  is_symmetric_ = sampled_symmetric();
}

void TourCosts::tabulate() {
  Points all;
  for (const Vec3& point : points_) all.push_back(point, transit_.place(point));
  table_.resize(nodes() * nodes());
  for (std::size_t u = 0; u < nodes(); ++u)
    transit_.lengths_m(points_[u], all, table_.data() + u * nodes());
}

bool TourCosts::sampled_symmetric() const {
  const auto count = static_cast<std::uint32_t>(nodes());
  const std::uint32_t most = table_.empty() ? 20 : count;  // others a node is compared with
  for (std::uint32_t u = 0; u < count; ++u)
    for (std::uint32_t n = 1; n < std::min(most, count); ++n) {
      const std::uint32_t v = (u + n) % count;
      if (!equal(directed(u, v), directed(v, u))) return false;
    }
  return true;
}

}  // namespace arcbid
