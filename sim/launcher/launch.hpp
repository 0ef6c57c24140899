// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include "core/base/error.hpp"
#include "core/faults/schedule.hpp"
#include "core/faults/tier.hpp"
#include "core/io/config.hpp"

namespace arcbid {

struct LaunchOptions {
  Config config;
  std::filesystem::path out;  ///< run directory; made if absent, must be empty
  std::optional<FaultSchedule> faults;
  FaultTier fault_tier = FaultTier::messages;
  std::filesystem::path programs;  ///< where arcbid-agent and arcbid-coordinator are
};

/// `arcbid run`: a coordinator and N agents as processes of their own, supervised until every
/// living agent has published its route, then checked, counted and shown. Leaves nothing running.
/// Exit::done only when the checker agrees; check_failed when it does not, the run was stopped or
/// took too long; bad_input when the coordinator says so.
Exit launch(const LaunchOptions& options);

}  // namespace arcbid
