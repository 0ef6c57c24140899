// SPDX-License-Identifier: GPL-3.0-or-later
#include "agent/agent_process.hpp"
#include "core/io/process/command_line.hpp"

int main(int argc, char** argv) {
  using namespace arcbid;
  stop_on_signals();
  CLI::App app{
      "One UAV of the fleet. Waits for a mission on the network, bids for its arcs, and once agreement "
      "is proven plans and publishes its route. 'arcbid run' starts these by itself; on several hosts "
      "start one on each, all with the same CONFIG.",
      "arcbid-agent"};
  app.set_version_flag("--version", ARCBID_VERSION);
  std::string config_file, run;
  std::uint32_t id = 0;
  std::optional<std::uint32_t> domain;
  AgentOptions options;
  bool with_parent = false;
  app.add_option("config", config_file, "the run's YAML file; its network and fleet size are used")
      ->required();
  app.add_option("--id", id, "this agent's id, as in the fleet")
      ->required()
      ->check(CLI::Range(1, 65535));
  app.add_option("--domain", domain, "DDS domain id (default: the config's)")
      ->check(CLI::Range(0, 232));
  app.add_option("--run", run, "run directory for route and event log (default: none is written)");
  app.add_option("--epoch-ns", options.epoch_ns, "launch time on the monotonic clock (default: now)");
  app.add_flag("--json-events", options.json_events, "report one JSON object a line");
  app.add_flag("--with-parent", with_parent, "end when the process that started this one ends");
  return run_command_line(app, argc, argv, [&] {
    if (with_parent) end_with_parent();
    const Config config = load_config(config_file);
    options.id = {id};
    options.network = config.network;
    options.domain = domain.value_or(config.network.domain.value_or(0));
    options.fleet_size = fleet_size(config);
    if (!run.empty()) options.run = run;
    if (options.epoch_ns == 0) options.epoch_ns = monotonic_ns();
    return AgentProcess(std::move(options)).run();
  });
}
