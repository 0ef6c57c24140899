// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/random/mersenne_twister.hpp>
#include <cstdint>

#include "sim/tour/rivals.hpp"

namespace arcbid {

/// Random changes of orders, which the genetic algorithm and the swarm share.
class OrderMoves {
 public:
  using Order = OrderSearch::Order;

  explicit OrderMoves(std::uint64_t seed) : random_(seed) {}

  std::size_t below(std::size_t limit) { return random_() % limit; }
  bool happens(std::uint32_t percent) { return below(100) < percent; }

  Order shuffled(std::size_t size);
  /// A stretch of the mother's, the rest in the father's order (order crossover; Davis 1985).
  Order crossed(const Order& mother, const Order& father);
  /// A stretch turned, or its last arc put before its first.
  void mutate(Order& order);

 private:
  boost::random::mt19937_64 random_;
};

}  // namespace arcbid
