// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

namespace arcbid {

/// Chance that is the same on every machine: SplitMix64 (Steele, Lea, Flood 2014), and exponential
/// deviates by plain arithmetic, for log() may differ in its last bits.
class TradeDice {
 public:
  explicit TradeDice(std::uint64_t seed);
  /// 0 to `count` - 1.
  std::uint32_t below(std::uint32_t count) {
    return static_cast<std::uint32_t>(((next() >> 32) * count) >> 32);
  }
  /// Of mean 1, one of 4096 values.
  double exponential() { return deviates_[next() >> 52]; }

 private:
  std::uint64_t next();

  std::uint64_t state_;
  std::array<double, 4096> deviates_;
};

}  // namespace arcbid
