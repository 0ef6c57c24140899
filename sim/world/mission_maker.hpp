// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/world/dice.hpp"
#include "sim/world/spec.hpp"

namespace arcbid {

/// Straight arcs in a box and UAVs on its floor, cut into a number of pieces within the settings'.
Mission make_mission(const WorldSettings& settings, std::uint64_t seed, Dice& dice);

/// Faults for that fleet. All of them end by `settings.until_ns`.
FaultSchedule make_faults(const WorldSettings& settings, const Mission& mission, std::uint64_t seed,
                          Dice& dice);

}  // namespace arcbid
