// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "agent/agent_process.hpp"
#include "core/io/faults/fault_files.hpp"
#include "core/io/process/command_line.hpp"

namespace {

using namespace arcbid;

/// The ids asked for, ascending. All must be of the fleet, and none asked for twice.
std::vector<AgentId> members(std::vector<std::uint32_t> ids, const std::vector<AgentId>& fleet,
                             const std::string& config_file) {
  std::sort(ids.begin(), ids.end());
  std::vector<AgentId> out;
  for (const std::uint32_t id : ids) {
    if (std::find(fleet.begin(), fleet.end(), AgentId{id}) == fleet.end()) {
      std::string legal;
      for (const AgentId agent : fleet) legal += fmt::format(" {}", agent.value);
      throw InputError(
          fmt::format("--id {}: is not of the fleet in {}; legal are{}", id, config_file, legal));
    }
    if (!out.empty() && out.back() == AgentId{id})
      throw InputError(fmt::format("--id {}: is given twice; each UAV once", id));
    out.push_back({id});
  }
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  stop_on_signals();
  CLI::App app{
      "One UAV of the fleet. Waits for a mission on the network, bids for its arcs, and once "
      "agreement "
      "is proven plans and publishes its route. 'arcbid run' starts these by itself; on several "
      "hosts "
      "start one on each, all with the same CONFIG.",
      "arcbid-agent"};
  app.set_version_flag("--version", ARCBID_VERSION);
  std::string config_file, run, faults, fault_tier;
  std::vector<std::uint32_t> ids;
  std::optional<std::uint32_t> domain;
  AgentOptions options;
  int parent = 0;
  app.add_option("config", config_file, "the run's YAML file; its network and fleet size are used")
      ->required();
  app.add_option("--id", ids,
                 "this agent's id, as in the fleet; several (1,2,3): UAVs that share this process")
      ->required()
      ->delimiter(',')
      ->check(CLI::Range(1, 65535));
  app.add_option("--domain", domain, "DDS domain id (default: the config's)")
      ->check(CLI::Range(0, 232));
  app.add_option("--run", run, "run directory for route and event log (default: none is written)");
  CLI::Option* with_faults = app.add_option(
      "--faults", faults,
      "fault file or preset (docs/FAULTS.md): what goes wrong on the way to this agent");
  app.add_option("--fault-tier", fault_tier,
                 "what the faults of links act on: messages (default), or packets, under DDS")
      ->check(CLI::IsMember({"messages", "packets"}))
      ->needs(with_faults);
  app.add_option("--epoch-ns", options.epoch_ns,
                 "launch time on the monotonic clock (default: now)");
  app.add_flag("--json-events", options.json_events, "report one JSON object a line");
  app.add_option("--parent", parent, "end when this process, the one that started it, ends");
  return run_command_line(app, argc, argv, [&] {
    if (parent != 0) end_with_parent(parent);
    const Config config = load_config(config_file);
    const std::vector<AgentId> fleet = fleet_ids(config);
    if (!run.empty()) options.run = run;
    if (!faults.empty()) options.faults = load_faults(faults, fleet);
    if (fault_tier == name_of(FaultTier::packets)) options.fault_tier = FaultTier::packets;
    if (options.epoch_ns == 0) options.epoch_ns = monotonic_ns();
    ProcessOptions process{config.network, domain_of(domain, config), fleet_size(config), {}};
    if (ids.size() > 1 && options.fault_tier == FaultTier::packets)
      throw InputError("--fault-tier packets: acts on a process's packets; give it one --id only");
    for (const AgentId id : members(ids, fleet, config_file)) {
      options.id = id;
      process.agents.push_back(options);
    }
    return AgentProcess(std::move(process)).run();
  });
}
