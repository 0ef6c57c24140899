// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/replay/evidence.hpp"

namespace arcbid {

/// Reads the log that `log` names, as far as it can be read, and fills in the rest. `number`: its
/// place among the reports.
void examine_log(LogReport& log, std::size_t number, Evidence& evidence);

}  // namespace arcbid
