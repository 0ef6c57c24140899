// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/io/config.hpp"
#include "core/io/config/report.hpp"

namespace arcbid::yaml {

/// Reports values that are legal one by one but do not go together.
void check_together(const Config& config, Report& report);

}  // namespace arcbid::yaml
