// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/arcs/arc.hpp"
#include "core/base/digest.hpp"

namespace arcbid {

/// The numbers that a world is made from: SplitMix64 (Steele, Lea, Flood 2014), the same on every
/// platform.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(Digest::mix(seed)) {}

  double unit() {  ///< in [0, 1)
    state_ += 0x9e3779b97f4a7c15ULL;
    return static_cast<double>(Digest::mix(state_) >> 11) * 0x1p-53;
  }
  /// In [least, most], both included.
  std::uint32_t between(std::uint32_t least, std::uint32_t most) {
    return least + static_cast<std::uint32_t>(unit() * (static_cast<double>(most - least) + 1));
  }
  double within(double least, double most) { return least + (most - least) * unit(); }
  TimeNs time_ns(TimeNs least, TimeNs most) {
    return least + static_cast<TimeNs>(unit() * static_cast<double>(most - least));
  }
  bool chance(double probability) { return unit() < probability; }

 private:
  std::uint64_t state_;
};

}  // namespace arcbid
