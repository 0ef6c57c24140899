// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trades/annealing.hpp"

#include <algorithm>
#include <utility>

namespace arcbid {
namespace {

constexpr std::uint32_t home_odds = 64;  // one wish in so many is to be next to a home
constexpr std::uint32_t most_moved = 3;  // lots at once
constexpr double rounded = 1e-6;         // of an endurance: legs are rounded here

bool is_limited(const Trader& trader) {
  const Trader free;
  return trader.endurance_s < free.endurance_s || trader.most_tasks < free.most_tasks ||
         trader.payload != Payload::any;
}

/// By how much it is over each limit.
struct Excess {
  double seconds = 0;
  std::uint32_t tasks = 0, unserved = 0;
  bool any() const { return seconds > 0 || tasks > 0 || unserved > 0; }
  bool exceeds(const Excess& other) const {
    return seconds > other.seconds || tasks > other.tasks || unserved > other.unserved;
  }
};

Excess excess(const Trader& trader, double time_s, const Load& load) {
  const std::uint32_t lidar = serves(trader.payload, Payload::lidar) ? 0 : load.lidar;
  const std::uint32_t camera = serves(trader.payload, Payload::camera) ? 0 : load.camera;
  return {std::max(0.0, time_s - trader.endurance_s * (1 - rounded)),
          load.tasks - std::min(load.tasks, trader.most_tasks), lidar + camera};
}

}  // namespace

Annealing::Annealing(Tours tours, const Legs& legs, const std::vector<Trader>& traders,
                     TradeDice& dice)
    : tours_(std::move(tours)),
      legs_(legs),
      traders_(traders),
      dice_(dice),
      limited_(std::ranges::any_of(traders, is_limited)),
      weights_(traders.size()) {}

double Annealing::weight(double time_s) const {
  double weight = time_s / reference_s_;
  for (int k = 0; k < squarings_; ++k) weight *= weight;
  return weight;
}

double Annealing::slowest_s() const {
  double slowest_s = 0;
  for (std::uint32_t a = 0; a < tours_.count(); ++a)
    slowest_s = std::max(slowest_s, time_s(a, tours_.length_m(a)));
  return slowest_s;
}

std::optional<Change> Annealing::propose() {
  const auto lots = static_cast<std::uint32_t>(tours_.lots());
  Wish wish;
  wish.one = dice_.below(2 * lots);
  const auto near = legs_.near(wish.one);
  if (near.empty() || dice_.below(home_odds) == 0)
    wish.other = 2 * lots + dice_.below(2 * tours_.count());
  else
    wish.other = near[dice_.below(static_cast<std::uint32_t>(near.size()))];
  const std::uint32_t kind = dice_.below(16);
  if (kind < 3) return move_lots(tours_, wish, 0);
  if (kind < 6) return move_lots(tours_, wish, dice_.below(most_moved));
  if (kind >= 10) return cross(tours_, wish);
  const std::uint32_t bits = dice_.below(8);
  return swap_lots(tours_, wish, bits & 1, (bits >> 1) & 1, (bits & 4) != 0);
}

bool Annealing::is_allowed(std::uint32_t tour, double length_m, const Recipe& recipe) const {
  const Trader& trader = traders_[tour];
  const Excess after = excess(trader, time_s(tour, length_m), tours_.load(recipe));
  if (!after.any()) return true;
  return !after.exceeds(excess(trader, time_s(tour, tours_.length_m(tour)), tours_.load(tour)));
}

bool Annealing::is_allowed(const Change& change) const {
  return is_allowed(change.a, change.length_a_m, change.tour_a) &&
         (change.b == Change::none || is_allowed(change.b, change.length_b_m, change.tour_b));
}

void Annealing::run(std::uint64_t changes, double temperature_s, int squarings) {
  squarings_ = squarings;
  reference_s_ = slowest_s();
  if (!(reference_s_ > 0)) return;
  for (std::uint32_t a = 0; a < tours_.count(); ++a)
    weights_[a] = weight(time_s(a, tours_.length_m(a)));
  // A second of the slowest one then counts as a second.
  const double scale_s = reference_s_ / static_cast<double>(1 << squarings_);
  for (std::uint64_t n = 0; n < changes; ++n) {
    const auto change = propose();
    if (!change || (limited_ && !is_allowed(*change))) continue;
    const bool of_two = change->b != Change::none;
    const double a = weight(time_s(change->a, change->length_a_m));
    const double b = of_two ? weight(time_s(change->b, change->length_b_m)) : 0;
    const double before = weights_[change->a] + (of_two ? weights_[change->b] : 0);
    if ((a + b - before) * scale_s > temperature_s * dice_.exponential()) continue;
    tours_.apply(*change);
    weights_[change->a] = a;
    if (!of_two) continue;
    weights_[change->b] = b;
    ++exchanges_;
  }
}

}  // namespace arcbid
