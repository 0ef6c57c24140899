// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tour/order_moves.hpp"

#include <algorithm>
#include <numeric>

namespace arcbid {

namespace {

constexpr std::uint32_t kTurnPercent = 60;

}  // namespace

OrderMoves::Order OrderMoves::shuffled(std::size_t size) {
  Order order(size);
  std::iota(order.begin(), order.end(), 0U);
  for (std::size_t i = size; i > 1; --i) std::swap(order[i - 1], order[below(i)]);
  return order;
}

OrderMoves::Order OrderMoves::crossed(const Order& mother, const Order& father) {
  const std::size_t size = mother.size();
  std::size_t begin = below(size), end = below(size);
  if (end < begin) std::swap(begin, end);
  Order child(size);
  std::vector<std::uint8_t> is_taken(size, 0);
  for (std::size_t n = begin; n <= end; ++n) is_taken[child[n] = mother[n]] = 1;
  std::size_t to = (end + 1) % size;
  for (std::size_t n = 0; n < size; ++n) {
    const std::uint32_t arc = father[(end + 1 + n) % size];
    if (is_taken[arc]) continue;
    child[to] = arc;
    to = (to + 1) % size;
  }
  return child;
}

void OrderMoves::mutate(Order& order) {
  std::size_t begin = below(order.size()), end = below(order.size());
  if (end < begin) std::swap(begin, end);
  const auto first = order.begin() + static_cast<std::ptrdiff_t>(begin);
  const auto last = order.begin() + static_cast<std::ptrdiff_t>(end);
  if (happens(kTurnPercent))
    std::reverse(first, last + 1);
  else
    std::rotate(first, last, last + 1);
}

}  // namespace arcbid
