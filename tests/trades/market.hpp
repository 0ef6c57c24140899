// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <cstdint>
#include <vector>

#include "core/trades/allocation.hpp"

namespace arcbid {

/// Traders and lots at random in a box of 100 m, and some allocation of them.
struct Market {
  Market(std::uint64_t seed, std::size_t traders, std::size_t lots);
  std::vector<Trader> traders;
  std::vector<Lot> lots;
  Allocation start;
  boost::random::mt19937_64 dice;

  double within(double least, double most);
  std::uint32_t below(std::size_t count);
};

/// Everybody's time in the plain reading, slowest first or not: the largest of them.
double plain_slowest_s(const Market& market, const Allocation& allocation, const Transit& transit);

/// How often each lot is flown.
std::vector<std::size_t> flown(const Allocation& allocation, std::size_t lots);

/// Wind from the west: a leg to the east is shorter than the way back.
class WindyTransit : public StraightTransit {
 public:
  double length_m(const Vec3& from, const Vec3& to) const override {
    return (to - from).norm() - 0.3 * (to - from).x();
  }
  void lengths_m(const Vec3& from, const Points& to, double* out) const override {
    Transit::lengths_m(from, to, out);
  }
  void lengths_m(const Points& from, const Vec3& to, double* out) const override {
    Transit::lengths_m(from, to, out);
  }
};

}  // namespace arcbid
