// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tour/greedy.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace arcbid {

namespace {

constexpr std::uint32_t kFree = UINT32_MAX;

/// Arcs joined to paths, until one is left.
class Paths {
 public:
  explicit Paths(std::size_t nodes) : partner_(nodes, kFree), other_end_(nodes) {
    for (std::uint32_t node = 0; node < nodes; ++node) other_end_[node] = node ^ 1U;
  }

  /// Joins two ends of different paths; else does nothing.
  bool join(std::uint32_t u, std::uint32_t v) {
    if (partner_[u] != kFree || partner_[v] != kFree || other_end_[u] == v) return false;
    partner_[u] = v;
    partner_[v] = u;
    const std::uint32_t a = other_end_[u], b = other_end_[v];
    other_end_[a] = b;
    other_end_[b] = a;
    return true;
  }

  std::vector<std::uint32_t> ends() const {
    std::vector<std::uint32_t> out;
    for (std::uint32_t node = 0; node < partner_.size(); ++node)
      if (partner_[node] == kFree) out.push_back(node);
    return out;
  }

  /// What is left when there are two ends.
  std::vector<std::uint32_t> closed() && {
    const std::vector<std::uint32_t> last = ends();
    partner_[last[0]] = last[1];
    partner_[last[1]] = last[0];
    std::vector<std::uint32_t> entries;
    std::uint32_t entry = 0;
    do {
      entries.push_back(entry);
      entry = partner_[entry ^ 1U];
    } while (entry != 0);
    return entries;
  }

 private:
  std::vector<std::uint32_t> partner_;    // by node
  std::vector<std::uint32_t> other_end_;  // of a path, by end
};

void join_cheapest_first(Paths& paths, const std::vector<std::uint32_t>& ends,
                         const Neighbours& neighbours) {
  std::vector<std::tuple<double, std::uint32_t, std::uint32_t>> legs;
  for (const std::uint32_t u : ends)
    for (const Neighbour& v : neighbours.of(u))
      legs.emplace_back(v.cost, std::min(u, v.node), std::max(u, v.node));
  std::ranges::sort(legs);
  for (const auto& [cost, u, v] : legs) paths.join(u, v);
}

}  // namespace

std::vector<std::uint32_t> greedy_entries(const TourCosts& costs, const Neighbours& neighbours) {
  Paths paths(costs.nodes());
  std::vector<std::uint32_t> ends = paths.ends();
  join_cheapest_first(paths, ends, neighbours);
  // Of the ends left over each has the nearest of another path among its neighbours, so that every
  // round joins some.
  for (ends = paths.ends(); ends.size() > 2; ends = paths.ends())
    join_cheapest_first(paths, ends, Neighbours(costs, ends));
  return std::move(paths).closed();
}

}  // namespace arcbid
