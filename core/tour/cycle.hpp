// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/tour/costs.hpp"

namespace arcbid {

/// Legs to take out of a cycle and legs to put in.
struct Exchange {
  static constexpr std::size_t kMostLegs = 6;

  std::size_t legs = 0;                            ///< how many go, and how many come
  std::array<std::uint32_t, 2 * kMostLegs> ends;   ///< leg n that goes joins 2n and 2n + 1
  std::array<std::uint8_t, 2 * kMostLegs> joined;  ///< ends[i] is to be joined to ends[joined[i]]
};

/// A closed tour over arcs as an array of the nodes by which they are entered, where exchanges of
/// legs can be tried, made and taken back. Its cost is that of its legs in the cheaper sense of
/// travel: the sum of their mean costs less what travelling in that sense saves.
class Cycle {
 public:
  /// `entries`: the first node of each arc, in flying order; at least three arcs.
  Cycle(const TourCosts& costs, std::vector<std::uint32_t> entries);

  const std::vector<std::uint32_t>& entries() const { return entries_; }
  std::uint32_t arcs() const { return static_cast<std::uint32_t>(entries_.size()); }
  /// The node that `node` is connected to by a leg, and that leg's mean cost.
  std::uint32_t partner(std::uint32_t node) const { return partner_[node]; }
  double leg(std::uint32_t node) const { return leg_[node]; }
  std::uint32_t gap_of(std::uint32_t node) const;
  double cost() const;

  /// Whether one closed tour is left after `exchange`; also prepares `saved` and `make`.
  bool closes(const Exchange& exchange);
  /// Of the exchange that was last asked about, besides the legs' mean costs: what the sense of
  /// travel saves then, less what it saves now.
  double saved() const { return std::abs(planned_excess_) - std::abs(excess()); }
  /// Makes the exchange that was last asked about, which must close. Time: the positions outside
  /// the longest stretch that stays.
  void make(const Exchange& exchange);
  /// Takes back all that was made since the last `keep`.
  void take_back();
  void keep();

 private:
  struct Made {
    std::uint32_t begin, count;  // positions that were written, cyclic
    Exchange exchange;
  };

  std::uint32_t after(std::uint32_t position) const {
    return position + 1 == arcs() ? 0 : position + 1;
  }
  bool is_entry(std::uint32_t node) const { return entries_[position_[node / 2]] == node; }
  std::uint32_t stretch(std::size_t rank, std::size_t legs) const;
  double excess() const { return excess_before_.empty() ? 0 : excess_before_.back(); }
  double stretch_excess(std::size_t rank, std::size_t legs) const;
  double excess_after(const Exchange& exchange) const;
  void write(const Exchange& exchange, std::size_t kept, std::uint32_t begin,
             const std::uint32_t* old);
  void put(std::uint32_t position, std::uint32_t entry);
  void join(std::uint32_t u, std::uint32_t v);
  void sum_excess();

  const TourCosts& costs_;
  std::vector<std::uint32_t> entries_, position_;  // by position; by arc
  std::vector<std::uint32_t> partner_;             // by node
  std::vector<double> leg_;                        // by node
  std::vector<double>
      excess_before_;  // of the legs before a position; empty where all is symmetric

  // Of the exchange last asked about. A gap is the place of a leg: gap p is between positions p and
  // p + 1. Stub 2r is the exit before the gap of rank r, stub 2r + 1 the entry after it.
  std::array<std::uint32_t, Exchange::kMostLegs> gap_{};
  std::array<std::uint8_t, 2 * Exchange::kMostLegs> end_at_{}, jump_{};
  double planned_excess_ = 0;

  std::vector<Made> made_;
  std::vector<std::uint32_t> overwritten_;
};

}  // namespace arcbid
