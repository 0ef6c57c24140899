// SPDX-License-Identifier: GPL-3.0-or-later
#include "agent/agent_process.hpp"

#include <algorithm>
#include <utility>

#include "core/io/process/process.hpp"

namespace arcbid {
namespace {

constexpr TimeNs longest_wait_ns = 50'000'000;  // signals are noticed between waits

std::vector<AgentId> ids_of(const std::vector<AgentOptions>& agents) {
  std::vector<AgentId> ids;
  for (const AgentOptions& agent : agents) ids.push_back(agent.id);
  return ids;
}

}  // namespace

AgentProcess::AgentProcess(ProcessOptions options)
    : bus_(options.network, options.domain, ids_of(options.agents), options.fleet_size,
           options.agents.front().fault_tier) {
  for (AgentOptions& agent : options.agents)
    agents_.push_back(std::make_unique<HostedAgent>(std::move(agent), bus_));
}

Exit AgentProcess::run() {
  while (!all_done() && !stop_requested()) {
    bus_.wait(wait_ns());
    for (const auto& agent : agents_) {
      if (agent->done()) continue;
      agent->turn();
      if (agent->done()) agent->finish();
    }
  }
  Exit exit = Exit::done;
  for (const auto& agent : agents_) {
    if (!agent->done()) agent->finish();
    exit = std::max(exit, agent->done().value_or(Exit::done));
  }
  return exit;
}

bool AgentProcess::all_done() const {
  return std::all_of(agents_.begin(), agents_.end(),
                     [](const auto& agent) { return agent->done().has_value(); });
}

std::chrono::nanoseconds AgentProcess::wait_ns() const {
  TimeNs wait = longest_wait_ns;
  for (const auto& agent : agents_)
    if (!agent->done()) wait = std::min(wait, agent->wait_ns());
  return std::chrono::nanoseconds(wait);
}

}  // namespace arcbid
