// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tour/cycle.hpp"

#include <algorithm>

namespace arcbid {

Cycle::Cycle(const TourCosts& costs, std::vector<std::uint32_t> entries)
    : costs_(costs),
      entries_(std::move(entries)),
      position_(entries_.size()),
      partner_(2 * entries_.size()),
      leg_(2 * entries_.size()) {
  for (std::uint32_t p = 0; p < arcs(); ++p) {
    position_[entries_[p] / 2] = p;
    join(entries_[p] ^ 1U, entries_[after(p)]);
  }
  sum_excess();
}

double Cycle::cost() const {
  double sum = 0;
  for (const std::uint32_t entry : entries_) sum += leg_[entry];
  return sum - std::abs(excess());
}

std::uint32_t Cycle::gap_of(std::uint32_t node) const {
  const std::uint32_t position = position_[node / 2];
  if (entries_[position] != node) return position;
  return position == 0 ? arcs() - 1 : position - 1;
}

bool Cycle::closes(const Exchange& exchange) {
  const std::size_t legs = exchange.legs, stubs = 2 * legs;
  std::array<std::uint8_t, Exchange::kMostLegs> by_rank;
  for (std::size_t n = 0; n < legs; ++n) {
    const std::uint32_t gap = gap_of(exchange.ends[2 * n]);
    std::size_t rank = n;
    for (; rank > 0 && gap_[rank - 1] > gap; --rank) {
      gap_[rank] = gap_[rank - 1];
      by_rank[rank] = by_rank[rank - 1];
    }
    gap_[rank] = gap;
    by_rank[rank] = static_cast<std::uint8_t>(n);
  }
  std::array<std::uint8_t, 2 * Exchange::kMostLegs> stub_of;
  for (std::size_t rank = 0; rank < legs; ++rank) {
    const std::size_t end = 2U * by_rank[rank];
    const std::size_t entry = is_entry(exchange.ends[end]) ? end : end + 1;
    end_at_[2 * rank] = static_cast<std::uint8_t>(entry ^ 1U);
    end_at_[2 * rank + 1] = static_cast<std::uint8_t>(entry);
    stub_of[entry ^ 1U] = static_cast<std::uint8_t>(2 * rank);
    stub_of[entry] = static_cast<std::uint8_t>(2 * rank + 1);
  }
  for (std::size_t end = 0; end < stubs; ++end) jump_[stub_of[end]] = stub_of[exchange.joined[end]];
  std::size_t stub = 1, visited = 0;
  do {
    const std::size_t across = (stub & 1U) != 0 ? stub + 1 : stub + stubs - 1;
    stub = jump_[across < stubs ? across : across - stubs];
    ++visited;
  } while (stub != 1);
  if (visited != legs) return false;
  if (!excess_before_.empty()) planned_excess_ = excess_after(exchange);
  return true;
}

std::uint32_t Cycle::stretch(std::size_t rank, std::size_t legs) const {
  return rank + 1 < legs ? gap_[rank + 1] - gap_[rank] : gap_[0] + arcs() - gap_[rank];
}

double Cycle::stretch_excess(std::size_t rank, std::size_t legs) const {
  const double before = excess_before_[gap_[rank] + 1];
  return rank + 1 < legs ? excess_before_[gap_[rank + 1]] - before
                         : excess() - before + excess_before_[gap_[0]];
}

double Cycle::excess_after(const Exchange& exchange) const {
  const std::size_t legs = exchange.legs, stubs = 2 * legs;
  double sum = 0;
  std::size_t stub = 1;
  do {
    const bool forward = (stub & 1U) != 0;
    const std::size_t across = (forward ? stub + 1 : stub + stubs - 1) % stubs;
    sum += forward ? stretch_excess(stub / 2, legs) : -stretch_excess(across / 2, legs);
    stub = jump_[across];
    sum += costs_.excess(exchange.ends[end_at_[across]], exchange.ends[end_at_[stub]]);
  } while (stub != 1);
  return sum;
}

void Cycle::make(const Exchange& exchange) {
  const std::size_t legs = exchange.legs;
  std::size_t kept = 0;
  for (std::size_t rank = 1; rank < legs; ++rank)
    if (stretch(rank, legs) > stretch(kept, legs)) kept = rank;
  const std::uint32_t begin = after(gap_[(kept + 1) % legs]);
  const std::uint32_t count = arcs() - stretch(kept, legs);
  const std::size_t old = overwritten_.size();
  const std::uint32_t before_wrap = std::min(count, arcs() - begin);
  overwritten_.insert(overwritten_.end(), entries_.begin() + begin,
                      entries_.begin() + begin + before_wrap);
  overwritten_.insert(overwritten_.end(), entries_.begin(),
                      entries_.begin() + (count - before_wrap));
  made_.push_back({begin, count, exchange});
  write(exchange, kept, begin, overwritten_.data() + old);
  for (std::size_t end = 0; end < 2 * legs; ++end)
    if (exchange.joined[end] > end) join(exchange.ends[end], exchange.ends[exchange.joined[end]]);
  sum_excess();
}

void Cycle::write(const Exchange& exchange, std::size_t kept, std::uint32_t begin,
                  const std::uint32_t* old) {
  const std::size_t legs = exchange.legs, stubs = 2 * legs;
  std::uint32_t to = begin;
  std::size_t stub = jump_[2 * (kept + 1) % stubs];
  while (stub != 2 * kept + 1) {
    const bool forward = (stub & 1U) != 0;
    const std::size_t across = (forward ? stub + 1 : stub + stubs - 1) % stubs;
    const std::size_t rank = (forward ? stub : across) / 2;
    const std::uint32_t first = after(gap_[rank]);
    const std::uint32_t* from = old + (first >= begin ? first - begin : first + arcs() - begin);
    const std::uint32_t length = stretch(rank, legs);
    for (std::uint32_t n = 0; n < length; ++n, to = after(to))
      put(to, forward ? from[n] : from[length - 1 - n] ^ 1U);
    stub = jump_[across];
  }
}

void Cycle::take_back() {
  for (; !made_.empty(); made_.pop_back()) {
    const Made& last = made_.back();
    const std::size_t old = overwritten_.size() - last.count;
    std::uint32_t to = last.begin;
    for (std::uint32_t n = 0; n < last.count; ++n, to = after(to)) put(to, overwritten_[old + n]);
    overwritten_.resize(old);
    for (std::size_t n = 0; n < last.exchange.legs; ++n)
      join(last.exchange.ends[2 * n], last.exchange.ends[2 * n + 1]);
  }
  sum_excess();
}

void Cycle::keep() {
  made_.clear();
  overwritten_.clear();
}

void Cycle::put(std::uint32_t position, std::uint32_t entry) {
  entries_[position] = entry;
  position_[entry / 2] = position;
}

void Cycle::join(std::uint32_t u, std::uint32_t v) {
  partner_[u] = v;
  partner_[v] = u;
  leg_[u] = leg_[v] = costs_.mean(u, v);
}

void Cycle::sum_excess() {
  if (costs_.is_symmetric()) return;
  excess_before_.resize(entries_.size() + 1);
  for (std::uint32_t p = 0; p < arcs(); ++p)
    excess_before_[p + 1] = excess_before_[p] + costs_.excess(entries_[p] ^ 1U, entries_[after(p)]);
}

}  // namespace arcbid
