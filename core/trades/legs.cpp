// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trades/legs.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace arcbid {

Legs::Legs(const std::vector<Trader>& traders, const std::vector<Lot>& lots, const Transit& transit,
           std::size_t neighbours)
    : nodes_(2 * (lots.size() + traders.size())),
      kept_(lots.size() < 2 ? 0 : std::min(neighbours, 2 * (lots.size() - 1))),
      lengths_m_(nodes_ * nodes_) {
  Points points;
  const auto add = [&](const Vec3& point) { points.push_back(point, transit.place(point)); };
  for (const Lot& lot : lots) {
    add(lot.first_m);
    add(lot.last_m);
  }
  for (const Trader& trader : traders) {
    add(trader.home_m);
    add(trader.home_m);
  }
  std::vector<double> row(nodes_);
  for (Node from = 0; from < nodes_; ++from) {
    transit.lengths_m(points.at(from), points, row.data());
    std::copy(row.begin(), row.end(),
              lengths_m_.begin() + static_cast<std::ptrdiff_t>(from * nodes_));
  }
  level();
  keep_near(lots.size());
}

/// In blocks that fit into the cache.
void Legs::level() {
  constexpr std::size_t block = 32;
  for (std::size_t top = 0; top < nodes_; top += block)
    for (std::size_t left = 0; left <= top; left += block)
      for (std::size_t a = top; a < std::min(top + block, nodes_); ++a)
        for (std::size_t b = left; b < std::min(left + block, a); ++b) {
          float &there = lengths_m_[a * nodes_ + b], &back = lengths_m_[b * nodes_ + a];
          if (there != back) there = back = 0.5F * (there + back);
        }
}

/// The nearest so far are kept in order; most others are not among them.
void Legs::keep_near(std::size_t lots) {
  near_.reserve(2 * lots * kept_);
  std::vector<std::pair<float, Node>> nearest(kept_);
  for (Node node = 0; node < 2 * lots && kept_ > 0; ++node) {
    std::fill(nearest.begin(), nearest.end(),
              std::pair{std::numeric_limits<float>::infinity(), Node{0}});
    const float* row = lengths_m_.data() + node * nodes_;
    for (Node other = 0; other < 2 * lots; ++other) {
      if (!(row[other] < nearest.back().first) || other / 2 == node / 2) continue;
      std::size_t place = kept_ - 1;
      for (; place > 0 && row[other] < nearest[place - 1].first; --place)
        nearest[place] = nearest[place - 1];
      nearest[place] = {row[other], other};
    }
    for (const auto& [length_m, other] : nearest) near_.push_back(other);
  }
}

}  // namespace arcbid
