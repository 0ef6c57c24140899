// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tour/local_search.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"

namespace arcbid {

namespace {

// Chosen on the nine matching instances of the paper's Table 2 and on random, clustered and gridded
// ones of 600 to 5,000 arcs.
constexpr std::size_t kMostLegs = 3;  ///< of an exchange
constexpr double kLeastGain = 1e-9;   ///< an exchange must gain more than rounding can
constexpr std::uint32_t kLongestStretch = 50;
constexpr std::uint32_t kWalkPercent = 80;  ///< of the disturbances; the others are along the tour
constexpr std::uint32_t kWalkSteps = 3;
constexpr std::uint32_t kWalkTries = 200;  ///< at most, to find four gaps
constexpr std::uint32_t kCandidates = 3;   ///< to begin a walk at the longest leg of these
/// A tour that is longer is welcome with probability exp(-excess / (this times the mean leg)).
constexpr double kTemperature = 0.1;

}  // namespace

LocalSearch::LocalSearch(const TourCosts& costs, const Neighbours& neighbours,
                         std::vector<std::uint32_t> entries, std::uint64_t seed)
    : costs_(costs),
      neighbours_(neighbours),
      cycle_(costs, std::move(entries)),
      random_(seed),
      queue_(costs.nodes()),
      is_queued_(costs.nodes(), 0) {
  for (const std::uint32_t entry : cycle_.entries()) {
    enqueue(entry);
    enqueue(entry ^ 1U);
  }
  settle();
  cycle_.keep();
  cost_ = best_cost_ = cycle_.cost();
  best_ = cycle_.entries();
}

void LocalSearch::settle() {
  while (queued_ > 0) {
    const std::uint32_t node = queue_[queue_begin_];
    queue_begin_ = queue_begin_ + 1 == queue_.size() ? 0 : queue_begin_ + 1;
    --queued_;
    is_queued_[node] = 0;
    while (improve(node)) continue;
  }
}

bool LocalSearch::improve(std::uint32_t node) {
  exchange_.legs = 1;
  exchange_.ends[0] = node;
  exchange_.ends[1] = cycle_.partner(node);
  return extend(cycle_.leg(node));
}

bool LocalSearch::takes_part(std::uint32_t node) const {
  const auto end = exchange_.ends.begin() + static_cast<std::ptrdiff_t>(2 * exchange_.legs);
  return std::find(exchange_.ends.begin(), end, node) != end;
}

bool LocalSearch::extend(double gain) {
  const std::size_t at = 2 * exchange_.legs;  // where the next leg's ends go
  for (const Neighbour& next : neighbours_.of(exchange_.ends[at - 1])) {
    const double rest = gain - next.cost;
    // Some rotation of every exchange that gains keeps gaining on the way (Lin, Kernighan 1973).
    // What the sense of travel saves is known at the end only, so there it proves nothing.
    if (costs_.is_symmetric() && rest <= kLeastGain) break;
    if (takes_part(next.node)) continue;
    exchange_.ends[at] = next.node;
    exchange_.ends[at + 1] = cycle_.partner(next.node);
    exchange_.joined[at - 1] = static_cast<std::uint8_t>(at);
    exchange_.joined[at] = static_cast<std::uint8_t>(at - 1);
    ++exchange_.legs;
    const double open = rest + cycle_.leg(next.node);
    if (close(open) || (exchange_.legs < kMostLegs && extend(open))) return true;
    --exchange_.legs;
  }
  return false;
}

bool LocalSearch::close(double open) {
  const std::size_t last = 2 * exchange_.legs - 1;
  const double gain = open - costs_.mean(exchange_.ends[last], exchange_.ends[0]);
  if (costs_.is_symmetric() && gain <= kLeastGain) return false;
  exchange_.joined[last] = 0;
  exchange_.joined[0] = static_cast<std::uint8_t>(last);
  if (!cycle_.closes(exchange_)) return false;
  const double whole = gain + cycle_.saved();
  if (!(whole > kLeastGain)) return false;
  cycle_.make(exchange_);
  gained_ += whole;
  for (std::size_t n = 0; n <= last; ++n) enqueue(exchange_.ends[n]);
  return true;
}

void LocalSearch::disturb() {
  if (cycle_.arcs() < 4) return;  // a double bridge takes four legs
  gained_ = 0;
  Gaps gaps;
  if (below(100) >= kWalkPercent || !walk_gaps(gaps)) gaps = stretch_gaps();
  bridge(gaps);
  settle();
  if (!is_welcome()) {
    cycle_.take_back();
    return;
  }
  cycle_.keep();
  cost_ -= gained_;
  if (!(cost_ < best_cost_ - kLeastGain)) return;
  best_cost_ = cost_ = cycle_.cost();  // summed anew: what was gained, added up, drifts
  best_ = cycle_.entries();
}

bool LocalSearch::is_welcome() {
  const double mean_leg = best_cost_ / cycle_.arcs();
  const double chance = static_cast<double>((random_() >> 11) + 1) * 0x1p-53;  // in (0, 1]
  return gained_ >= kTemperature * mean_leg * std::log(chance);
}

/// Four gaps with up to kLongestStretch arcs between one and the next.
LocalSearch::Gaps LocalSearch::stretch_gaps() {
  const std::uint32_t arcs = cycle_.arcs();
  const std::uint32_t longest = std::min(kLongestStretch, (arcs - 1) / 3);
  Gaps gaps{below(arcs)};
  for (std::size_t n = 1; n < gaps.size(); ++n) gaps[n] = (gaps[n - 1] + 1 + below(longest)) % arcs;
  return gaps;
}

/// Four gaps that are near each other in space, near a leg that is long as a rule: by random walks
/// along neighbours (Applegate, Cook, Rohe 2003). Small worlds may not have four.
bool LocalSearch::walk_gaps(Gaps& gaps) {
  const std::uint32_t nodes = 2 * cycle_.arcs();
  std::uint32_t start = below(nodes);
  for (std::uint32_t n = 1; n < kCandidates; ++n) {
    const std::uint32_t other = below(nodes);
    if (cycle_.leg(other) > cycle_.leg(start)) start = other;
  }
  auto end = gaps.begin();
  for (std::uint32_t n = 0; n < kWalkTries && end != gaps.end(); ++n) {
    std::uint32_t node = start;
    for (std::uint32_t step = 0; step < kWalkSteps + n / 8; ++step) {
      const auto near = neighbours_.of(node);
      node = near[below(static_cast<std::uint32_t>(near.size()))].node ^ below(2);
    }
    const std::uint32_t gap = cycle_.gap_of(node);
    if (std::find(gaps.begin(), end, gap) == end) *end++ = gap;
  }
  std::sort(gaps.begin(), end);
  return end == gaps.end();
}

/// A D C B of the stretches A B C D: the smallest exchange that no sequential one takes back.
void LocalSearch::bridge(const Gaps& gaps) {
  Exchange bridge{.legs = 4, .ends = {}, .joined = {5, 4, 7, 6, 1, 0, 3, 2}};
  for (std::size_t n = 0; n < 4; ++n) {
    const std::uint32_t exit = cycle_.entries()[gaps[n]] ^ 1U;
    bridge.ends[2 * n] = exit;
    bridge.ends[2 * n + 1] = cycle_.partner(exit);
    gained_ += cycle_.leg(exit);
  }
  check(cycle_.closes(bridge), "a double bridge leaves one tour");
  gained_ += cycle_.saved();
  cycle_.make(bridge);
  for (std::size_t n = 0; n < 4; ++n) gained_ -= cycle_.leg(bridge.ends[2 * n]);
  for (std::size_t n = 0; n < 8; ++n) enqueue(bridge.ends[n]);
}

void LocalSearch::enqueue(std::uint32_t node) {
  if (is_queued_[node]) return;
  is_queued_[node] = 1;
  queue_[(queue_begin_ + queued_++) % queue_.size()] = node;
}

std::uint32_t LocalSearch::below(std::uint32_t limit) {
  return static_cast<std::uint32_t>((random_() >> 32) * limit >> 32);
}

}  // namespace arcbid
