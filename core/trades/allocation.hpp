// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "core/arcs/arc.hpp"

namespace arcbid {

/// What changes hands as a whole: an arc or a part of one, flown in either direction. Metres, local
/// East-North-Up frame.
struct Lot {
  Vec3 first_m, last_m;
  double length_m = 0;
  std::uint32_t tasks = 1;         ///< that it consists of
  Payload payload = Payload::any;  ///< what it must be flown with
};

/// Who flies lots: home -> lots -> home, and within which limits.
struct Trader {
  Vec3 home_m = Vec3::Zero();
  double speed_mps = 1;
  double endurance_s = std::numeric_limits<double>::infinity();
  std::uint32_t most_tasks = std::numeric_limits<std::uint32_t>::max();
  Payload payload = Payload::any;  ///< what it carries
};

/// One lot of a path, and which way it is flown.
struct LotStop {
  std::uint32_t lot = 0;
  bool reversed = false;  ///< from last_m to first_m
  friend bool operator==(const LotStop&, const LotStop&) = default;
};

/// By trader, in flying order. Every lot stands in at most one path, once.
using Allocation = std::vector<std::vector<LotStop>>;

/// How long each trader is on its way, seconds.
std::vector<double> times_s(const std::vector<Trader>& traders, const std::vector<Lot>& lots,
                            const Allocation& allocation, const Transit& transit);

/// Whether each trader can fly what it has: `times_s` as above.
bool keeps_limits(const std::vector<Trader>& traders, const std::vector<Lot>& lots,
                  const Allocation& allocation, const std::vector<double>& times_s);

}  // namespace arcbid
