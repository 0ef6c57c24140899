// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/launcher/launch.hpp"

namespace arcbid {

/// What is done to a process is done to all that share it: no schedule means that. Throws InputError
/// where agents share processes and the faults, or their tier, are of single processes.
void require_own_processes(const LaunchOptions& options);

}  // namespace arcbid
