// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "sim/checker/run_files.hpp"

namespace arcbid::checker {

/// What is wrong by one check's rules: the first lines and the number of all.
class Problems {
 public:
  void add(std::string line) {
    ++count_;
    if (lines_.size() < kShown) lines_.push_back(std::move(line));
  }
  bool none() const { return count_ == 0; }
  std::size_t count() const { return count_; }
  const std::vector<std::string>& lines() const { return lines_; }

 private:
  static constexpr std::size_t kShown = 10;
  std::vector<std::string> lines_;
  std::size_t count_ = 0;
};

// Each check looks at all agents that delivered a readable route, ascending ids, at least one.

/// One and the same task table everywhere, agreed under one view, each task in it once.
Problems check_conflicts(const std::vector<Delivered>& all);

/// Every task has an owner that delivered, or lies in a stretch that is said to have no bidder.
Problems check_completeness(const std::vector<Delivered>& all);

/// What is said to have no bidder has none, and the reason holds as far as it can be recomputed: to
/// the last second where transits are straight, else against straight ones, which are shorter.
void check_left(const Published& published, const std::vector<Delivered>& all, Problems& problems);

/// Whether `left` holds all of from_m to to_m of the arc.
bool holds(const Left& left, std::uint32_t arc, double from_m, double to_m);

/// Tasks tile the arcs (split), and so do the legs flown and what is said to have no bidder
/// (combine).
Problems check_conservation(const Published& published, const std::vector<Delivered>& all);

/// One agent's route: home to home without a jump, on the arcs, just the tasks it won, with what it
/// carries and as long as it lasts.
void check_route(const Published& published, const Delivered& delivered, Problems& problems);

/// Sum over all legs' waypoints.
double flown_m(const Delivered& delivered);

}  // namespace arcbid::checker
