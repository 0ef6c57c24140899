// SPDX-License-Identifier: GPL-3.0-or-later
// A genetic algorithm over permutations; the best survive.
#include <algorithm>
#include <utility>

#include "sim/tour/order_moves.hpp"
#include "sim/tour/rivals.hpp"

namespace arcbid {
namespace {

constexpr std::size_t kPopulation = 100, kElite = 4, kTournament = 4;
constexpr std::uint32_t kCrossoverPercent = 80, kMutationPercent = 60;

using Order = OrderSearch::Order;

struct Member {
  Order order;
  double length_m = 0;
};

class Genetics {
 public:
  Genetics(OrderSearch& search, std::uint64_t seed) : search_(search), moves_(seed) {
    for (std::size_t n = 0; n < kPopulation; ++n) add(moves_.shuffled(search.arcs()));
    sort();
  }

  void breed() {
    const std::vector<Member> parents = std::exchange(members_, {});
    members_.assign(parents.begin(), parents.begin() + kElite);
    while (members_.size() < kPopulation) {
      const Order& mother = chosen(parents);
      Order child =
          moves_.happens(kCrossoverPercent) ? moves_.crossed(mother, chosen(parents)) : mother;
      if (moves_.happens(kMutationPercent)) moves_.mutate(child);
      add(std::move(child));
    }
    sort();
  }

 private:
  void add(Order order) {
    const double length_m = search_.length_m(order);
    members_.push_back({std::move(order), length_m});
  }
  void sort() { std::ranges::stable_sort(members_, {}, &Member::length_m); }

  /// The best of a few; members are sorted, so that the lowest number is.
  const Order& chosen(const std::vector<Member>& parents) {
    std::size_t best = moves_.below(parents.size());
    for (std::size_t n = 1; n < kTournament; ++n)
      best = std::min(best, moves_.below(parents.size()));
    return parents[best].order;
  }

  OrderSearch& search_;
  OrderMoves moves_;
  std::vector<Member> members_;
};

}  // namespace

void search_by_ga(OrderSearch& search, std::uint64_t seed, const GoesOn& goes_on) {
  Genetics genetics(search, seed);
  do genetics.breed();
  while (goes_on());
}

}  // namespace arcbid
