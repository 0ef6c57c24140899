// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/arcs/mission.hpp"
#include "core/io/run/json_place.hpp"

namespace arcbid {

/// The mission that to_json() wrote, bit for bit: its digest must be the one written beside it.
/// Throws InputError.
Mission mission_of(const JsonPlace& body);

}  // namespace arcbid
