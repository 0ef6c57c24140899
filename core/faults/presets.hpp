// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/faults/schedule.hpp"

namespace arcbid {

/// A schedule that is made to fit a fleet.
struct FaultPreset {
  std::string name;
  std::string meaning;  ///< one line for people
};

/// All presets, in the order of docs/FAULTS.md.
const std::vector<FaultPreset>& fault_presets();

/// The preset for a fleet (ascending ids, not empty). Throws InputError for a name that is none,
/// and for a fleet that is too small for it.
FaultSchedule preset(const std::string& name, const std::vector<AgentId>& fleet);

}  // namespace arcbid
