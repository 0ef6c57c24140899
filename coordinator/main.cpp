// SPDX-License-Identifier: GPL-3.0-or-later
#include "coordinator/coordinator_process.hpp"
#include "core/io/process/command_line.hpp"

int main(int argc, char** argv) {
  using namespace arcbid;
  stop_on_signals();
  CLI::App app{
      "Makes a structure into arcs, publishes them to the fleet as a mission, and ends the mission "
      "when "
      "every living agent has published its route. 'arcbid run' starts it by itself.",
      "arcbid-coordinator"};
  app.set_version_flag("--version", ARCBID_VERSION);
  std::string config_file, run;
  std::optional<std::uint32_t> domain;
  CoordinatorOptions options;
  int parent = 0;
  app.add_option("config", config_file, "the run's YAML file")->required();
  app.add_option("--domain", domain, "DDS domain id (default: the config's)")
      ->check(CLI::Range(0, 232));
  app.add_option("--run", run, "run directory for arcs and event log (default: none is written)");
  app.add_option("--epoch-ns", options.epoch_ns,
                 "launch time on the monotonic clock (default: now)");
  app.add_option("--not-before-ns", options.not_before_ns,
                 "no mission is complete before this, since launch: faults are still to come");
  app.add_flag("--json-events", options.json_events, "report one JSON object a line");
  app.add_option("--parent", parent, "end when this process, the one that started it, ends");
  return run_command_line(app, argc, argv, [&] {
    if (parent != 0) end_with_parent(parent);
    options.config = load_config(config_file);
    options.domain = domain_of(domain, options.config);
    if (!run.empty()) options.run = run;
    if (options.epoch_ns == 0) options.epoch_ns = monotonic_ns();
    return CoordinatorProcess(std::move(options)).run();
  });
}
