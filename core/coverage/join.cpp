// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <tuple>

#include "core/coverage/trim.hpp"

namespace arcbid {

namespace {

struct End {
  std::size_t arc;
  bool back;
};

const Vec3& place(const std::vector<Arc>& arcs, const End& end) {
  const auto& w = arcs[end.arc].waypoints;
  return (end.back ? w.back() : w.front()).position_m;
}

using Connection = std::tuple<double, std::size_t, bool, std::size_t, bool>;

std::vector<Connection> short_connections(const std::vector<Arc>& arcs, double most_m) {
  std::vector<Connection> found;
  for (std::size_t a = 0; a < arcs.size(); ++a)
    for (std::size_t b = a + 1; b < arcs.size(); ++b) {
      if (arcs[a].kind != ArcKind::gap && arcs[b].kind != ArcKind::gap) continue;
      for (int k = 0; k < 4; ++k) {
        const End from{a, (k & 1) != 0}, to{b, (k & 2) != 0};
        const double m = (place(arcs, from) - place(arcs, to)).norm();
        if (m <= most_m) found.emplace_back(m, a, from.back, b, to.back);
      }
    }
  std::sort(found.begin(), found.end());
  return found;
}

/// `first`'s end on to `second`'s start, both turned as needed.
std::vector<Waypoint> connected(std::vector<Waypoint> first, bool from_back,
                                std::vector<Waypoint> second, bool to_back) {
  if (!from_back) std::reverse(first.begin(), first.end());
  if (to_back) std::reverse(second.begin(), second.end());
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

}  // namespace

std::vector<Arc> joined_ends(std::vector<Arc> arcs, const Flyable& flyable,
                             const JoinLimits& limits) {
  // Ends of joined arcs meet new neighbours: again until nothing is left to join.
  for (bool joined = true; joined;) {
    joined = false;
    std::vector<bool> used(arcs.size()), gone(arcs.size());
    for (const auto& [m, a, a_back, b, b_back] : short_connections(arcs, limits.gap_m)) {
      Arc &first = arcs[a], &second = arcs[b];
      const Vec3 from = place(arcs, {a, a_back}), to = place(arcs, {b, b_back});
      const double first_m = length_m(first.waypoints), second_m = length_m(second.waypoints);
      if (used[a] || used[b] || m < 1e-6 || first_m + m + second_m > limits.arc_m ||
          !flyable.clears(from, to))
        continue;
      const ArcKind kind = first_m >= second_m ? first.kind : second.kind;
      first.waypoints = connected(first.waypoints, a_back, second.waypoints, b_back);
      first.kind = kind;
      used[a] = used[b] = gone[b] = joined = true;
    }
    std::vector<Arc> left;
    for (std::size_t a = 0; a < arcs.size(); ++a)
      if (!gone[a]) left.push_back(std::move(arcs[a]));
    arcs = std::move(left);
  }
  return arcs;
}

}  // namespace arcbid
