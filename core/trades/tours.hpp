// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/trades/legs.hpp"

namespace arcbid {

/// A lot as it is flown: the node where it is entered; it is left at the other one, Code ^ 1.
using Code = std::uint32_t;

/// Positions `first` to `last` of a tour, or the same the other way round.
struct TourPart {
  std::uint32_t tour = 0, first = 0, last = 0;
  bool reversed = false;
};

/// What a tour is made of anew: parts of tours as they are, home included at both ends.
struct Recipe {
  std::array<TourPart, 5> parts;
  std::uint32_t count = 0;
  void add(const TourPart& part) { parts[count++] = part; }
};

/// A change to one tour or to two. Both or none: `b` is none where only one changes.
struct Change {
  static constexpr std::uint32_t none = UINT32_MAX;
  std::uint32_t a = none, b = none;
  Recipe tour_a, tour_b;
  double length_a_m = 0, length_b_m = 0;
};

/// What of a tour is limited beside its time.
struct Load {
  std::uint32_t tasks = 0, lidar = 0, camera = 0;  // the latter: lots that need it
  Load& operator+=(const Load& more);
  Load& operator-=(const Load& less);
};

/// Everybody's closed tours, made for changes to be tried at O(1).
class Tours {
 public:
  Tours(const std::vector<Lot>& lots, const Legs& legs, const Allocation& allocation);

  std::size_t lots() const { return owner_.size(); }
  std::uint32_t count() const { return static_cast<std::uint32_t>(tours_.size()); }
  std::uint32_t owner(std::uint32_t lot) const { return owner_[lot]; }
  std::uint32_t position(std::uint32_t lot) const { return position_[lot]; }
  Code at(std::uint32_t tour, std::uint32_t position) const { return tours_[tour][position]; }
  /// Home's second position: the last.
  std::uint32_t end(std::uint32_t tour) const {
    return static_cast<std::uint32_t>(tours_[tour].size() - 1);
  }
  double length_m(std::uint32_t tour) const { return flown_m_[tour].back(); }

  double length_m(const Recipe& recipe) const;
  Load load(std::uint32_t tour) const { return carried_[tour].back(); }
  Load load(const Recipe& recipe) const;
  void apply(const Change& change);
  Allocation allocation() const;

 private:
  double within_m(const TourPart& part) const;
  void make(const Recipe& recipe, std::vector<Code>& tour) const;
  void renumber(std::uint32_t tour);

  const Legs* legs_;
  std::vector<double> lengths_m_;                // by lot; homes: 0
  std::vector<Load> loads_;                      // likewise
  std::vector<std::vector<Code>> tours_;         // home, lots, home
  std::vector<std::vector<double>> flown_m_;     // when each position is left
  std::vector<std::vector<Load>> carried_;       // likewise
  std::vector<std::uint32_t> owner_, position_;  // by lot
  std::vector<Code> fresh_a_, fresh_b_;          // room to work in
};

}  // namespace arcbid
