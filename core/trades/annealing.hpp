// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/trades/changes.hpp"
#include "core/trades/dice.hpp"
#include "core/trades/tours.hpp"

namespace arcbid {

/// Changes of one tour or of two, taken when they lower what the slow ones take, or, while it is
/// warm, when they raise it a little (Kirkpatrick, Gelatt, Vecchi 1983). Nobody is taken over its
/// limits; who is there from the start may come nearer to them. What is lowered is the sum
/// of a high power of everybody's time: nearly the longest alone, but one that the others' moves
/// are not lost on.
class Annealing {
 public:
  Annealing(Tours tours, const Legs& legs, const std::vector<Trader>& traders, TradeDice& dice);

  /// Tries so many changes at this temperature. `squarings`: the power is two to it.
  void run(std::uint64_t changes, double temperature_s, int squarings);
  /// Begins anew from here.
  void restart(Tours tours) { tours_ = std::move(tours); }

  const Tours& tours() const { return tours_; }
  double slowest_s() const;
  std::uint64_t exchanges() const { return exchanges_; }  ///< changes of two tours made so far

 private:
  std::optional<Change> propose();
  double time_s(std::uint32_t tour, double length_m) const {
    return length_m / traders_[tour].speed_mps;
  }
  double weight(double time_s) const;
  bool is_allowed(const Change& change) const;
  bool is_allowed(std::uint32_t tour, double length_m, const Recipe& recipe) const;

  Tours tours_;
  const Legs& legs_;
  const std::vector<Trader>& traders_;
  TradeDice& dice_;
  const bool limited_;  // at least one trader
  int squarings_ = 0;
  double reference_s_ = 1;  // weights are powers of shares of it
  std::vector<double> weights_;
  std::uint64_t exchanges_ = 0;
};

}  // namespace arcbid
