// SPDX-License-Identifier: GPL-3.0-or-later
// Arcs that run between members, where no cell is free, and ways from them into the open.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <queue>
#include <string>
#include <utility>

#include "core/airspace/build.hpp"
#include "core/airspace/deep_access.hpp"

namespace arcbid {
namespace {

constexpr std::size_t kMostNodes = 20'000;  // of one arc's own search

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

/// Shortest first, from all waypoints of an arc at once to the first place in a free cell.
class NearSearch {
 public:
  NearSearch(const FreeGrid& grid, const FineLattice& lattice) : grid_(grid), lattice_(lattice) {}

  std::optional<Access> find(const Arc& arc) {
    for (std::uint32_t w = 0; w < arc.waypoints.size(); ++w) {
      const Vec3& at = arc.waypoints[w].position_m;
      nodes_.push_back({at, lattice_.clear_m(at), w, 0, false});
      open_.emplace(0.0, w);
    }
    while (!open_.empty() && !gave_up()) {
      const std::uint32_t n = open_.top().second;
      open_.pop();
      if (std::exchange(nodes_[n].settled, true)) continue;
      if (grid_.free(nodes_[n].at)) return unrolled(arc, n);
      const Vec3 at = nodes_[n].at;
      lattice_.for_around(at, [&](const FineLattice::Index& to) { offer(n, to); });
    }
    return std::nullopt;
  }

  bool gave_up() const { return nodes_.size() >= kMostNodes; }

 private:
  void offer(std::uint32_t from, const FineLattice::Index& to) {
    const Vec3 at = lattice_.place(to);
    if (at.z() < grid_.low_m().z()) return;
    const double length_m = nodes_[from].length_m + (at - nodes_[from].at).norm();
    const auto next = static_cast<std::uint32_t>(nodes_.size());
    const auto [known, fresh] = known_.try_emplace(to, next);
    if (fresh) nodes_.push_back({.at = at, .clear_m = lattice_.clear_m(at), .from = from});
    FineLattice::Node& node = nodes_[known->second];
    if (node.settled || node.length_m <= length_m) return;
    if (!lattice_.clears(nodes_[from], node.at, node.clear_m)) return;
    node.from = from;
    node.length_m = length_m;
    open_.emplace(length_m, known->second);
  }

  Access unrolled(const Arc& arc, std::uint32_t n) const {
    std::vector<Vec3> way{nodes_[n].at};
    for (; nodes_[n].from != n; n = nodes_[n].from) way.push_back(nodes_[nodes_[n].from].at);
    std::reverse(way.begin(), way.end());
    return {arc.id, n, lattice_.shortened(way)};
  }

  using Entry = std::pair<double, std::uint32_t>;
  const FreeGrid& grid_;
  const FineLattice& lattice_;
  std::vector<FineLattice::Node> nodes_;
  std::map<FineLattice::Index, std::uint32_t> known_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
};

/// What an arc needs to be reached.
struct Reach {
  bool is_open = false;  ///< nothing
  std::optional<Access> access;
  bool reached() const { return is_open || access; }
};

std::vector<Reach> reach(const std::vector<Arc>& arcs, const FreeGrid& grid,
                         const Structure& structure, double safety_m) {
  std::vector<Reach> all;
  for (const Arc& arc : arcs) all.push_back({has_free_point(arc, grid), {}});
  if (std::all_of(all.begin(), all.end(), [](const Reach& r) { return r.is_open; })) return all;
  const ExactClearance clearance(structure, safety_m);
  const FineLattice lattice(grid, clearance);
  std::vector<const Arc*> deep;
  std::vector<std::size_t> number;
  for (std::size_t a = 0; a < arcs.size(); ++a) {
    if (all[a].is_open) continue;
    NearSearch search(grid, lattice);
    all[a].access = search.find(arcs[a]);
    if (all[a].access || !search.gave_up()) continue;
    deep.push_back(&arcs[a]);
    number.push_back(a);
  }
  auto found = deep_accesses(deep, grid, lattice);
  for (std::size_t d = 0; d < deep.size(); ++d) all[number[d]].access = std::move(found[d]);
  return all;
}

std::string left_out(const Arc& arc, double step_m) {
  const Vec3& p = arc.waypoints.front().position_m;
  return fmt::format(
      "arc {}, {:.1f} m long at ({:.1f}, {:.1f}, {:.1f}), cannot be reached and is left out: the "
      "surface closes it in at the safety distance, but for passages narrower than {:.2g} m",
      arc.id.value, length_m(arc.waypoints), p.x(), p.y(), p.z(), step_m);
}

}  // namespace

void connect(std::vector<Arc>& arcs, const Structure& structure, double safety_m,
             Airspace& airspace, std::vector<std::string>& warnings) {
  const FreeGrid grid(airspace);
  std::vector<Reach> all = reach(arcs, grid, structure, safety_m);
  std::vector<Arc> kept;
  for (std::size_t a = 0; a < arcs.size(); ++a) {
    if (!all[a].reached()) {
      warnings.push_back(left_out(arcs[a], grid.cell_m() / 2));
      continue;
    }
    arcs[a].id.value = static_cast<std::uint32_t>(kept.size());
    if (all[a].access) {
      all[a].access->arc = arcs[a].id;
      airspace.accesses.push_back(std::move(*all[a].access));
    }
    kept.push_back(std::move(arcs[a]));
  }
  arcs = std::move(kept);
}

}  // namespace arcbid
