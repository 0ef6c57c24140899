// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "agent/agent_process.hpp"
#include "core/io/faults/fault_files.hpp"
#include "core/io/process/command_line.hpp"

int main(int argc, char** argv) {
  using namespace arcbid;
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
  std::uint32_t id = 0;
  std::optional<std::uint32_t> domain;
  AgentOptions options;
  int parent = 0;
  app.add_option("config", config_file, "the run's YAML file; its network and fleet size are used")
      ->required();
  app.add_option("--id", id, "this agent's id, as in the fleet")
      ->required()
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
    options.id = {id};
    const std::vector<AgentId> fleet = fleet_ids(config);
    if (std::find(fleet.begin(), fleet.end(), options.id) == fleet.end()) {
      std::string legal;
      for (const AgentId agent : fleet) legal += fmt::format(" {}", agent.value);
      throw InputError(
          fmt::format("--id {}: is not of the fleet in {}; legal are{}", id, config_file, legal));
    }
    options.network = config.network;
    options.domain = domain_of(domain, config);
    options.fleet_size = fleet_size(config);
    if (!run.empty()) options.run = run;
    if (!faults.empty()) options.faults = load_faults(faults, fleet);
    if (fault_tier == name_of(FaultTier::packets)) options.fault_tier = FaultTier::packets;
    if (options.epoch_ns == 0) options.epoch_ns = monotonic_ns();
    return AgentProcess(std::move(options)).run();
  });
}
