// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "core/arcs/mission.hpp"

namespace arcbid {

/// Why a mission on record is none that anybody flew: it cannot be split into tasks, its fleet is
/// no fleet, or a setting is none. Values that the wire refuses are refused here too; places are
/// within 1000 km as well, and tasks no more than a config can ask for. None: it may be one.
std::optional<std::string> misfit(const Mission& mission);

}  // namespace arcbid
