// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structure/cuts.hpp"

#include <algorithm>
#include <limits>
#include <optional>

namespace arcbid {

namespace {

/// Index of the point of `ring` nearest to any point of `others`. Stacked equal outlines tie all
/// the way round: the first point is taken unless another is nearer by more than rounding.
std::optional<std::size_t> nearest_point(const Track& ring, const std::vector<Track>& others) {
  constexpr double kTie_m = 1e-6;
  std::optional<std::size_t> best;
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.points.size(); ++i)
    for (const Track& other : others)
      for (const Vec3& p : other.points) {
        const double distance_m = (p - ring.points[i]).norm();
        if (distance_m >= least_m - kTie_m) continue;
        least_m = distance_m;
        best = i;
      }
  return best;
}

/// From point `from` of the ring on to point `to`; all round if they are one.
Track piece(const Track& ring, std::size_t from, std::size_t to) {
  Track open;
  std::size_t i = from;
  do {
    open.points.push_back(ring.points[i]);
    i = (i + 1) % ring.points.size();
  } while (i != to);
  open.points.push_back(ring.points[to]);
  return open;
}

}  // namespace

std::vector<Track> cut_open(const std::vector<Track>& outlines, const std::vector<Track>& above,
                            const std::vector<Track>& below, double least_m) {
  std::vector<Track> open;
  for (const Track& outline : outlines) {
    if (!outline.closed) {
      open.push_back(outline);
      continue;
    }
    const auto p_in = nearest_point(outline, above), p_out = nearest_point(outline, below);
    const std::size_t first = p_in ? *p_in : p_out.value_or(0), second = p_out.value_or(first);
    const Track there = piece(outline, first, second), back = piece(outline, second, first);
    if (first == second || std::min(length_m(there), length_m(back)) < least_m) {
      open.push_back(piece(outline, first, first));
    } else {
      open.push_back(there);
      open.push_back(back);
    }
  }
  return open;
}

}  // namespace arcbid
