// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trades/exchanges.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/error.hpp"
#include "core/trades/annealing.hpp"

namespace arcbid {
namespace {

/// How much is tried. Temperatures are shares of the mean leg.
struct Effort {
  std::uint64_t changes = 0, cycles = 0;
  std::size_t neighbours = 0;
  double hot = 0, cold = 0;
};

constexpr int temperatures = 64;  // of a cycle, each a step; a power of two
constexpr int squarings = 4;      // the 16th power while it is warm
constexpr int last_squarings = 6;
constexpr std::uint64_t last_share =
    20;  // of the changes: one in so many, at last, when it is cold

/// Full: until more does not gain much, but at most what takes a second. Cheap: what all traders
/// do together takes a tenth of that.
Effort effort_of(TradesKind kind, std::size_t lots, std::size_t traders) {
  if (kind == TradesKind::full) {
    const std::uint64_t most = lots < 1000 ? 9'000'000 - 4000 * lots : 5'000'000;
    const std::uint64_t changes = std::min<std::uint64_t>(80000 * lots, most);
    const auto cycles = std::max<std::uint64_t>(1, changes / (40000 * lots));
    return {changes, cycles, 12, 0.5, 0.03};
  }
  const std::uint64_t changes = std::min<std::uint64_t>(4000 * lots, 450'000 / traders);
  return {changes, 1, 8, 0.1, 0.02};
}

double slowest(const std::vector<double>& times_s) {
  return *std::max_element(times_s.begin(), times_s.end());
}

void check_whole(const Allocation& start, std::size_t traders, std::size_t lots) {
  std::vector<std::uint32_t> times(lots);
  for (const auto& path : start)
    for (const LotStop& stop : path) ++times.at(stop.lot);
  check(start.size() == traders &&
            std::count(times.begin(), times.end(), 1U) == static_cast<std::ptrdiff_t>(lots),
        "every lot that is exchanged has one owner");
}

}  // namespace

struct Exchanges::Search {
  const std::vector<Trader> traders;
  const std::vector<Lot> lots;
  const Transit& transit;
  Allocation best;
  double best_s = 0;
  Effort effort;
  std::unique_ptr<Legs> legs;
  TradeDice dice;
  std::unique_ptr<Annealing> annealing;
  double hot_s = 0, cooling = 1, temperature_s = 0;
  std::uint64_t cycle = 0;
  int step = 0;  // of the cycle

  Search(std::vector<Trader> who, std::vector<Lot> what, Allocation start, const Transit& way,
         std::uint64_t seed)
      : traders(std::move(who)),
        lots(std::move(what)),
        transit(way),
        best(std::move(start)),
        dice(seed) {}
  void begin(TradesKind kind);
  void take_step();
  void end_cycle();
};

void Exchanges::Search::begin(TradesKind kind) {
  if (kind == TradesKind::off || lots.empty()) return;
  effort = effort_of(kind, lots.size(), traders.size());
  legs = std::make_unique<Legs>(traders, lots, transit, effort.neighbours);
  const std::vector<double> before_s = times_s(traders, lots, best, transit);
  best_s = keeps_limits(traders, lots, best, before_s) ? slowest(before_s)
                                                       : std::numeric_limits<double>::infinity();
  double legs_s = 0;
  for (std::size_t a = 0; a < traders.size(); ++a) {
    legs_s += before_s[a];
    for (const LotStop& stop : best[a]) legs_s -= lots[stop.lot].length_m / traders[a].speed_mps;
  }
  hot_s = effort.hot * std::max(0.0, legs_s) / static_cast<double>(lots.size());
  cooling = effort.cold / effort.hot;
  for (int n = 1; n < temperatures; n *= 2) cooling = std::sqrt(cooling);
  annealing = std::make_unique<Annealing>(Tours(lots, *legs, best), *legs, traders, dice);
}

void Exchanges::Search::take_step() {
  const std::uint64_t changes = effort.changes / effort.cycles, last = changes / last_share;
  if (step == 0) temperature_s = hot_s;
  if (step < temperatures) {
    annealing->run((changes - last) / temperatures, temperature_s, squarings);
    temperature_s *= cooling;
    ++step;
    return;
  }
  annealing->run(last, 0, last_squarings);
  end_cycle();
}

/// What was searched with is rounded, and the mean of both ways: what is kept is measured anew.
void Exchanges::Search::end_cycle() {
  Allocation found = annealing->tours().allocation();
  const std::vector<double> found_s = times_s(traders, lots, found, transit);
  if (slowest(found_s) < best_s && keeps_limits(traders, lots, found, found_s)) {
    best = std::move(found);
    best_s = slowest(found_s);
  }
  annealing->restart(Tours(lots, *legs, best));
  step = 0;
  ++cycle;
}

Exchanges::Exchanges(std::vector<Trader> traders, std::vector<Lot> lots, Allocation start,
                     const Transit& transit, TradesKind kind, std::uint64_t seed) {
  check_whole(start, traders.size(), lots.size());
  search_ = std::make_unique<Search>(std::move(traders), std::move(lots), std::move(start), transit,
                                     seed);
  search_->begin(kind);
}

Exchanges::~Exchanges() = default;

bool Exchanges::done() const {
  return search_->cycle == search_->effort.cycles;
}

void Exchanges::step() {
  if (!done()) search_->take_step();
}

const Allocation& Exchanges::best() const {
  return search_->best;
}

std::uint64_t Exchanges::count() const {
  return search_->annealing ? search_->annealing->exchanges() : 0;
}

Allocation exchanged(std::vector<Trader> traders, std::vector<Lot> lots, Allocation start,
                     const Transit& transit, TradesKind kind, std::uint64_t seed) {
  Exchanges exchanges(std::move(traders), std::move(lots), std::move(start), transit, kind, seed);
  while (!exchanges.done()) exchanges.step();
  return exchanges.best();
}

}  // namespace arcbid
