// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tour/kd_tree.hpp"

#include <algorithm>

namespace arcbid {

namespace {

constexpr std::uint32_t kLeafItems = 8;

}  // namespace

KdTree::KdTree(std::span<const Vec3> points, std::span<const std::uint32_t> chosen) {
  items_.reserve(chosen.size());
  for (const std::uint32_t point : chosen) {
    const Vec3& at = points[point];
    items_.push_back({{at.x(), at.y(), at.z()}, point});
  }
  if (!items_.empty()) build(0, static_cast<std::uint32_t>(items_.size()));
}

void KdTree::build(std::uint32_t begin, std::uint32_t end) {
  Cell cell{items_[begin].at, items_[begin].at, begin, end};
  for (std::uint32_t n = begin + 1; n < end; ++n)
    for (std::size_t a = 0; a < 3; ++a) {
      cell.low[a] = std::min(cell.low[a], items_[n].at[a]);
      cell.high[a] = std::max(cell.high[a], items_[n].at[a]);
    }
  const std::size_t number = cells_.size();
  cells_.push_back(cell);
  if (end - begin <= kLeafItems) return;

  std::size_t widest = 0;
  for (std::size_t a = 1; a < 3; ++a)
    if (cell.high[a] - cell.low[a] > cell.high[widest] - cell.low[widest]) widest = a;
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(items_.begin() + begin, items_.begin() + middle, items_.begin() + end,
                   [widest](const Item& a, const Item& b) {
                     return a.at[widest] != b.at[widest] ? a.at[widest] < b.at[widest]
                                                         : a.point < b.point;
                   });
  build(begin, middle);
  cells_[number].upper = static_cast<std::uint32_t>(cells_.size());
  build(middle, end);
}

void KdTree::nearest(std::uint32_t from, const Vec3& at, unsigned octant,
                     std::span<Found> found) const {
  std::ranges::fill(found, Found{});
  if (!cells_.empty()) search(0, {{at.x(), at.y(), at.z()}, from / 2, octant, found});
}

double KdTree::least_squared_m(const Cell& cell, const Query& query) {
  double sum = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    if (query.octant != everywhere) {
      const bool above = (query.octant >> a & 1U) != 0;
      if (above ? cell.high[a] < query.at[a] : cell.low[a] >= query.at[a])
        return std::numeric_limits<double>::infinity();
    }
    const double away = std::max({0.0, cell.low[a] - query.at[a], query.at[a] - cell.high[a]});
    sum += away * away;
  }
  return sum;
}

void KdTree::offer(const Item& item, const Query& query) {
  double sum = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    const double away = item.at[a] - query.at[a];
    if (query.octant != everywhere && (away >= 0) != ((query.octant >> a & 1U) != 0)) return;
    sum += away * away;
  }
  if (!(sum < query.found.back().squared_m) || item.point / 2 == query.pair) return;
  std::size_t n = query.found.size() - 1;
  for (; n > 0 && sum < query.found[n - 1].squared_m; --n) query.found[n] = query.found[n - 1];
  query.found[n] = {sum, item.point};
}

void KdTree::search(std::uint32_t number, const Query& query) const {
  const Cell& cell = cells_[number];
  if (cell.upper == 0) {
    for (std::uint32_t n = cell.begin; n < cell.end; ++n) offer(items_[n], query);
    return;
  }
  const double lower_m2 = least_squared_m(cells_[number + 1], query);
  const double upper_m2 = least_squared_m(cells_[cell.upper], query);
  const bool lower_first = lower_m2 <= upper_m2;
  if (std::min(lower_m2, upper_m2) < query.found.back().squared_m)
    search(lower_first ? number + 1 : cell.upper, query);
  if (std::max(lower_m2, upper_m2) < query.found.back().squared_m)
    search(lower_first ? cell.upper : number + 1, query);
}

}  // namespace arcbid
