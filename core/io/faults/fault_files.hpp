// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/faults/presets.hpp"
#include "core/faults/schedule.hpp"

namespace arcbid {

/// The schedule of a preset, made for `fleet` (ascending ids, not empty), or of a YAML file
/// (docs/FAULTS.md) whose agents must be in the fleet. Throws InputError: everything wrong in the
/// file, one line each ("bad.yaml:3:14: links[0].loss: 2 is outside [0, 1]"); for what is neither
/// preset nor file, one line that lists the presets.
FaultSchedule load_faults(const std::string& preset_or_file, const std::vector<AgentId>& fleet);

/// The same from text; `file` stands in the messages. An empty fleet: any agent may be named.
FaultSchedule parse_faults(const std::string& text, const std::filesystem::path& file,
                           const std::vector<AgentId>& fleet = {});

/// YAML that parse_faults reads back to the same value, when the schedule is legal.
std::string to_yaml(const FaultSchedule& schedule);

/// A table of every key, what is legal, its default and meaning, in Markdown (part of
/// docs/FAULTS.md).
std::string fault_reference();

/// A table of the presets in Markdown (part of docs/FAULTS.md).
std::string fault_preset_reference();

}  // namespace arcbid
