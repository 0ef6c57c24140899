// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/arcs/mission.hpp"

namespace arcbid {

/// The transit that everybody who has the mission makes alike, bit for bit: around its obstacles,
/// with all lengths between homes and tasks' end points known, or straight where it names none.
/// Throws InputError for an airspace that no coordinator makes.
std::shared_ptr<const Transit> make_transit(const Mission& mission);

}  // namespace arcbid
