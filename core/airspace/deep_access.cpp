// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/airspace/deep_access.hpp"

#include <functional>
#include <queue>
#include <unordered_map>
#include <utility>

namespace arcbid {
namespace {

using Index = FineLattice::Index;

class Flood {
 public:
  Flood(const std::vector<const Arc*>& arcs, const FreeGrid& grid, const FineLattice& lattice)
      : arcs_(arcs), grid_(grid), lattice_(lattice) {
    for (std::size_t a = 0; a < arcs.size(); ++a)
      for (std::uint32_t w = 0; w < arcs[a]->waypoints.size(); ++w)
        ends_[key(lattice.index(arcs[a]->waypoints[w].position_m))].push_back({a, w});
  }

  std::vector<std::optional<Access>> run() {
    std::vector<std::optional<Access>> found(arcs_.size());
    std::size_t missing = found.size();
    add_rim();
    while (!open_.empty() && missing > 0) {
      const std::uint32_t n = open_.top().second;
      open_.pop();
      if (std::exchange(nodes_[n].settled, true)) continue;
      const Vec3 at = nodes_[n].at;
      lattice_.for_around(at, [&](const Index& to) {
        if (!holds(to)) return;
        offer(n, to);
        const auto ends = ends_.find(key(to));
        if (ends == ends_.end()) return;
        for (const End& end : ends->second)
          if (!found[end.arc] && (found[end.arc] = meet(end, n))) --missing;
      });
    }
    return found;
  }

 private:
  struct End {
    std::size_t arc;
    std::uint32_t waypoint;
  };

  bool holds(const Index& i) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (i[k] < 0 || i[k] >= 2 * grid_.size()[k]) return false;
    return true;
  }
  std::uint64_t key(const Index& i) const {
    const std::int64_t nx = 2 * grid_.size()[0], ny = 2 * grid_.size()[1];
    return static_cast<std::uint64_t>(i[0] + nx * (i[1] + ny * i[2]));
  }
  bool is_free(const Index& i) const {
    return grid_.free(
        Cell{static_cast<int>(i[0] / 2), static_cast<int>(i[1] / 2), static_cast<int>(i[2] / 2)});
  }

  /// The free cells that have others beside them: all of their places.
  void add_rim() {
    const Cell& size = grid_.size();
    for (int z = 0; z < size[2]; ++z)
      for (int y = 0; y < size[1]; ++y)
        for (int x = 0; x < size[0]; ++x) {
          if (!grid_.on_rim({x, y, z})) continue;
          for (int k = 0; k < 8; ++k) {
            const Index i{2 * x + k % 2, 2 * y + k / 2 % 2, 2 * z + k / 4};
            const auto n = static_cast<std::uint32_t>(nodes_.size());
            known_[key(i)] = n;
            // All of a free cell keeps the distance: nothing more is asked there.
            nodes_.push_back({lattice_.place(i), lattice_.required_m(), n, 0, false});
            open_.emplace(0.0, n);
          }
        }
  }

  void offer(std::uint32_t from, const Index& to) {
    if (is_free(to)) return;
    const auto next = static_cast<std::uint32_t>(nodes_.size());
    const auto [known, fresh] = known_.try_emplace(key(to), next);
    if (fresh) {
      const Vec3 at = lattice_.place(to);
      nodes_.push_back({.at = at, .clear_m = lattice_.clear_m(at), .from = from});
    }
    FineLattice::Node& node = nodes_[known->second];
    const double length_m = nodes_[from].length_m + (node.at - nodes_[from].at).norm();
    if (node.settled || node.length_m <= length_m) return;
    if (!lattice_.clears(nodes_[from], node.at, node.clear_m)) return;
    node.from = from;
    node.length_m = length_m;
    open_.emplace(length_m, known->second);
  }

  std::optional<Access> meet(const End& end, std::uint32_t n) const {
    const Arc& arc = *arcs_[end.arc];
    const Vec3& at = arc.waypoints[end.waypoint].position_m;
    if (!lattice_.clears(nodes_[n], at, lattice_.clear_m(at))) return std::nullopt;
    std::vector<Vec3> way{at, nodes_[n].at};
    for (; nodes_[n].from != n; n = nodes_[n].from) way.push_back(nodes_[nodes_[n].from].at);
    return Access{arc.id, end.waypoint, lattice_.shortened(way)};
  }

  using Entry = std::pair<double, std::uint32_t>;
  const std::vector<const Arc*>& arcs_;
  const FreeGrid& grid_;
  const FineLattice& lattice_;
  std::unordered_map<std::uint64_t, std::vector<End>> ends_;  // by the lattice place they are at
  std::vector<FineLattice::Node> nodes_;
  std::unordered_map<std::uint64_t, std::uint32_t> known_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
};

}  // namespace

std::vector<std::optional<Access>> deep_accesses(const std::vector<const Arc*>& arcs,
                                                 const FreeGrid& grid, const FineLattice& lattice) {
  if (arcs.empty()) return {};
  return Flood(arcs, grid, lattice).run();
}

}  // namespace arcbid
