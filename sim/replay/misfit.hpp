// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "core/io/record/records.hpp"

namespace arcbid {

/// What in a step is about tasks or agents that its mission does not have: a record that still
/// reads but was damaged. Messages that the core refused may hold anything. None: it fits.
std::optional<std::string> misfit(const Step& step, const Mission& mission, std::size_t tasks);

}  // namespace arcbid
