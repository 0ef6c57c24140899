// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <cstdint>

namespace arcbid {

/// Numbers that look random, the same for a seed everywhere.
class Chance {
 public:
  explicit Chance(std::uint32_t seed) : random_(seed) {}
  double real(double low, double high) {
    return boost::random::uniform_real_distribution<double>(low, high)(random_);
  }
  int below(int end) { return boost::random::uniform_int_distribution<int>(0, end - 1)(random_); }
  bool once_in(int times) { return below(times) == 0; }
  double normal(double deviation) {
    return boost::random::normal_distribution<double>(0, deviation)(random_);
  }
  /// Within a half cube on the ground.
  Eigen::Vector3d within(double side) {
    const double x = real(-side, side), y = real(-side, side);
    return {x, y, real(0, side)};
  }

 private:
  boost::random::mt19937 random_;
};

}  // namespace arcbid
