// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "core/arcs/mission.hpp"

namespace arcbid {

/// The mission's transit, whose table of lengths the agents of one machine work out once: the first
/// leaves it in RUN/transit.bin, the others wait for it and read it. Where that cannot be, or the
/// file is damaged, an agent works it out by itself, with the same result.
std::shared_ptr<const Transit> shared_transit(const Mission& mission,
                                              const std::filesystem::path& run);

}  // namespace arcbid
