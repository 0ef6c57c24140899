// SPDX-License-Identifier: GPL-3.0-or-later
// Arcs that run between members, where no cell is free, and ways from them into the open.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <queue>
#include <utility>

#include "core/airspace/build.hpp"
#include "core/airspace/exact.hpp"
#include "core/airspace/free_grid.hpp"

namespace arcbid {
namespace {

constexpr std::size_t kMostNodes = 20'000;  // of one search
constexpr double kUnreached = std::numeric_limits<double>::infinity();

bool has_free_point(const Arc& arc, const FreeGrid& grid) {
  const double stride_m = grid.cell_m() / 4;
  for (std::size_t w = 0; w < arc.waypoints.size(); ++w) {
    const Vec3& to = arc.waypoints[w].position_m;
    const Vec3& from = arc.waypoints[w > 0 ? w - 1 : 0].position_m;
    const double steps = std::max(1.0, std::ceil((to - from).norm() / stride_m));
    for (double k = 1; k <= steps; ++k)
      if (grid.free(Vec3(from + k / steps * (to - from)))) return true;
  }
  return false;
}

/// Shortest first over a lattice twice as fine as the cells, every edge checked against the surface
/// itself, from all waypoints of an arc at once to the first place in a free cell.
class AccessSearch {
 public:
  AccessSearch(const FreeGrid& grid, const ExactClearance& clearance)
      : grid_(grid),
        clearance_(clearance),
        required_m_(clearance.required_m()),
        step_m_(grid.cell_m() / 2) {}

  std::optional<Access> find(const Arc& arc) {
    for (std::uint32_t w = 0; w < arc.waypoints.size(); ++w) {
      const Vec3& at = arc.waypoints[w].position_m;
      nodes_.push_back({at, clearance_.distance_m(at), w, 0, false});
      open_.emplace(0.0, w);
    }
    while (!open_.empty() && nodes_.size() < kMostNodes) {
      const std::uint32_t n = open_.top().second;
      open_.pop();
      if (std::exchange(nodes_[n].settled, true)) continue;
      if (grid_.free(nodes_[n].at)) return unrolled(arc, n);
      expand(n);
    }
    return std::nullopt;
  }

  bool gave_up() const { return nodes_.size() >= kMostNodes; }

 private:
  using Index = std::array<std::int64_t, 3>;
  struct Node {
    Vec3 at;
    double clear_m;      // distance from the surface
    std::uint32_t from;  // itself for a waypoint
    double length_m;
    bool settled;
  };

  void expand(std::uint32_t n) {
    const Vec3 at = nodes_[n].at;
    const Vec3 units = ((at - grid_.low_m()) / step_m_).array().floor();
    for (int k = 0; k < 27; ++k) {
      Index index{};
      for (int axis = 0, rest = k; axis < 3; ++axis, rest /= 3)
        index[static_cast<std::size_t>(axis)] =
            static_cast<std::int64_t>(units[axis]) + rest % 3 - 1;
      offer(n, index);
    }
  }

  /// A distance is 1-Lipschitz, so those of both ends settle nearly all edges.
  bool clears(const Node& a, const Node& b) const {
    if (b.clear_m < required_m_) return false;
    if ((a.clear_m + b.clear_m - (b.at - a.at).norm()) / 2 >= required_m_) return true;
    return clearance_.clears(a.at, b.at);
  }

  void offer(std::uint32_t from, const Index& index) {
    const Vec3 at = grid_.low_m() + step_m_ * Vec3(static_cast<double>(index[0]) + 0.5,
                                                   static_cast<double>(index[1]) + 0.5,
                                                   static_cast<double>(index[2]) + 0.5);
    if (at.z() < grid_.low_m().z()) return;
    const double length_m = nodes_[from].length_m + (at - nodes_[from].at).norm();
    const auto [known, fresh] = index_.try_emplace(index, nodes_.size());
    if (fresh) nodes_.push_back({at, clearance_.distance_m(at), from, kUnreached, false});
    const std::uint32_t n = known->second;
    if (nodes_[n].settled || nodes_[n].length_m <= length_m) return;
    if (!clears(nodes_[from], nodes_[n])) return;
    nodes_[n].from = from;
    nodes_[n].length_m = length_m;
    open_.emplace(length_m, n);
  }

  Access unrolled(const Arc& arc, std::uint32_t n) const {
    std::vector<Vec3> way{nodes_[n].at};
    for (; nodes_[n].from != n; n = nodes_[n].from) way.push_back(nodes_[nodes_[n].from].at);
    std::reverse(way.begin(), way.end());
    Access access{arc.id, n, {{way.front()}}};
    for (std::size_t k = 0; k + 1 < way.size();) {
      std::size_t next = way.size() - 1;
      while (next > k + 1 && !clearance_.clears(way[k], way[next])) --next;
      access.points.push_back({way[next]});
      k = next;
    }
    return access;
  }

  using Entry = std::pair<double, std::uint32_t>;
  const FreeGrid& grid_;
  const ExactClearance& clearance_;
  double required_m_, step_m_;
  std::vector<Node> nodes_;
  std::map<Index, std::uint32_t> index_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
};

}  // namespace

void connect(std::vector<Arc>& arcs, const Structure& structure, double safety_m,
             Airspace& airspace, std::vector<std::string>& warnings) {
  const FreeGrid grid(airspace);
  std::optional<ExactClearance> clearance;  // most structures need none
  std::vector<Arc> kept;
  for (Arc& arc : arcs) {
    std::optional<Access> access;
    if (!has_free_point(arc, grid)) {
      if (!clearance) clearance.emplace(structure, safety_m);
      AccessSearch search(grid, *clearance);
      access = search.find(arc);
      if (!access) {
        const Vec3& p = arc.waypoints.front().position_m;
        warnings.push_back(fmt::format(
            "arc {}, {:.1f} m long at ({:.1f}, {:.1f}, {:.1f}), cannot be reached and is left out: "
            "{}",
            arc.id.value, length_m(arc.waypoints), p.x(), p.y(), p.z(),
            search.gave_up() ? "no way out was found near it"
                             : "the surface closes it in at the safety distance"));
        continue;
      }
    }
    arc.id.value = static_cast<std::uint32_t>(kept.size());
    if (access) {
      access->arc = arc.id;
      airspace.accesses.push_back(std::move(*access));
    }
    kept.push_back(std::move(arc));
  }
  arcs = std::move(kept);
}

}  // namespace arcbid
