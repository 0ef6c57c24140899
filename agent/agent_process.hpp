// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "agent/hosted_agent.hpp"
#include "agent/shared_bus.hpp"
#include "core/io/config.hpp"

namespace arcbid {

struct ProcessOptions {
  NetworkConfig network;
  std::uint32_t domain = 0;
  std::uint32_t fleet_size = 4;
  std::vector<AgentOptions> agents;  ///< ascending ids, at least one
};

/// A process of the fleet: a bus and the UAVs on it, one as a rule. Several share one where a
/// machine cannot carry a process for each (fleet.agents_per_process).
class AgentProcess {
 public:
  explicit AgentProcess(ProcessOptions options);

  /// Until the coordinator ends the mission, or a signal asks to stop.
  Exit run();

 private:
  bool all_done() const;
  std::chrono::nanoseconds wait_ns() const;

  SharedBus bus_;
  std::vector<std::unique_ptr<HostedAgent>> agents_;
};

}  // namespace arcbid
