// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "core/io/record/records.hpp"

namespace arcbid {

/// What in a step is about tasks or agents that its mission does not have: a record that still
/// reads but was damaged. Messages that the core refused may hold anything. None: it fits.
std::optional<std::string> misfit(const Step& step, const Mission& mission, std::size_t tasks);

/// Why a mission on record is none that anybody flew: it cannot be split into tasks, or its fleet
/// is no fleet. The rules are those for missions on the wire. None: it may be one.
std::optional<std::string> misfit(const Mission& mission);

}  // namespace arcbid
