// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/launcher/shared_processes.hpp"

#include <fmt/format.h>

#include <vector>

namespace arcbid {

void require_own_processes(const LaunchOptions& options) {
  const std::uint32_t shared = options.config.fleet.agents_per_process;
  if (!options.faults || shared == 1) return;
  if (options.fault_tier == FaultTier::packets)
    throw InputError(fmt::format(
        "--fault-tier packets: acts on the packets of processes, but fleet.agents_per_process is "
        "{}; only 1 gives every agent a process of its own",
        shared));
  const std::vector<AgentFault>& faults = options.faults->agents;
  for (std::size_t n = 0; n < faults.size(); ++n) {
    using Kind = AgentFaultKind;
    // Who bids over everybody ends its process.
    const bool ends =
        faults[n].kind == Kind::malformed && faults[n].malformation == Malformation::over_bid;
    const bool on_process =
        ends || (faults[n].kind != Kind::clock && faults[n].kind != Kind::malformed);
    if (on_process && faults[n].agent != AgentId{0})
      throw InputError(fmt::format(
          "agents[{}] of the fault schedule: is done to the process of agent {}, but "
          "fleet.agents_per_process is {}; only 1 gives every agent a process of its own",
          n, faults[n].agent.value, shared));
  }
}

}  // namespace arcbid
