// SPDX-License-Identifier: GPL-3.0-or-later
// A MAX-MIN ant system (Stuetzle, Hoos 2000) over the ends of arcs, without local search. Own code:
// pagmo's gaco is for continuous variables.
#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <cmath>

#include "sim/tour/rivals.hpp"

namespace arcbid {
namespace {

constexpr std::size_t kAnts = 25;
constexpr double kBeta = 3, kEvaporation = 0.05;
constexpr std::uint64_t kGlobalEvery = 4;  ///< else the colony's best lays the trail

/// Node 2a is the first end of arc a, 2a + 1 the last, the last node is home.
class Colony {
 public:
  Colony(OrderSearch& search, std::uint64_t seed)
      : search_(search), random_(seed), home_(2 * search.arcs()), nodes_(home_ + 1) {
    for (const TourArc& arc : search.all_arcs()) {
      points_.push_back(arc.first_m);
      points_.push_back(arc.last_m);
    }
    points_.push_back(search.home_m());
    const double mean_m = (points_.front() - points_.back()).norm() + 1e-9;
    near_.resize(nodes_ * nodes_);
    for (std::size_t u = 0; u < nodes_; ++u)
      for (std::size_t v = 0; v < nodes_; ++v) {
        const double length_m = search.transit().length_m(points_[u], points_[v]);
        near_[u * nodes_ + v] = std::pow(1 / (length_m / mean_m + 1e-6), kBeta);
      }
    trail_.assign(nodes_ * nodes_, 1);
    weight_ = near_;
  }

  void march() {
    OrderSearch::Order best;
    double best_m = 0;
    for (std::size_t ant = 0; ant < kAnts; ++ant) {
      const OrderSearch::Order order = walked();
      const double length_m = search_.length_m(order);
      if (best.empty() || length_m < best_m) {
        best = order;
        best_m = length_m;
      }
    }
    ++marches_;
    lay_trail(marches_ % kGlobalEvery == 0 ? search_.best_order() : best);
  }

 private:
  OrderSearch::Order walked() {
    std::vector<std::uint32_t> left(search_.arcs());
    for (std::uint32_t arc = 0; arc < left.size(); ++arc) left[arc] = arc;
    OrderSearch::Order order;
    std::size_t at = home_;
    std::vector<double> sum(2 * left.size());
    while (!left.empty()) {
      double total = 0;
      for (std::size_t n = 0; n < left.size(); ++n)
        for (std::size_t end = 0; end < 2; ++end)
          sum[2 * n + end] = total += weight_[at * nodes_ + 2 * left[n] + end];
      const double drawn = total * static_cast<double>(random_() >> 11) * 0x1p-53;
      const auto last = sum.begin() + static_cast<std::ptrdiff_t>(2 * left.size() - 1);
      const auto chosen = std::upper_bound(sum.begin(), last, drawn) - sum.begin();
      const std::size_t n = static_cast<std::size_t>(chosen) / 2;
      const std::size_t entry = 2 * left[n] + static_cast<std::size_t>(chosen) % 2;
      order.push_back(left[n]);
      at = entry ^ 1U;
      left[n] = left.back();
      left.pop_back();
    }
    return order;
  }

  /// Trails stay within bounds, so that no leg is ever ruled out. They are relative: the most is 1.
  void lay_trail(const OrderSearch::Order& order) {
    const double least = 1 / (2.0 * static_cast<double>(nodes_));
    for (double& trail : trail_) trail = std::max(least, (1 - kEvaporation) * trail);
    const Tour tour =
        best_directions(search_.all_arcs(), order, search_.home_m(), search_.transit());
    std::size_t at = home_;
    for (const Stop& stop : tour.stops) {
      const std::size_t entry = 2 * stop.arc + (stop.reversed ? 1 : 0);
      strengthen(at, entry);
      at = entry ^ 1U;
    }
    strengthen(at, home_);
    for (std::size_t n = 0; n < weight_.size(); ++n) weight_[n] = trail_[n] * near_[n];
  }

  void strengthen(std::size_t u, std::size_t v) {
    for (double* trail : {&trail_[u * nodes_ + v], &trail_[v * nodes_ + u]})
      *trail = std::min(1.0, *trail + kEvaporation);
  }

  OrderSearch& search_;
  boost::random::mt19937_64 random_;
  std::size_t home_, nodes_;
  std::uint64_t marches_ = 0;
  std::vector<Vec3> points_;
  std::vector<double> near_, trail_, weight_;  // from, to
};

}  // namespace

void search_by_aco(OrderSearch& search, std::uint64_t seed, const GoesOn& goes_on) {
  Colony colony(search, seed);
  do colony.march();
  while (goes_on());
}

}  // namespace arcbid
