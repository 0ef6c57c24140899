// SPDX-License-Identifier: GPL-3.0-or-later
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <thread>

#include "core/io/faults/fault_files.hpp"
#include "core/io/process/command_line.hpp"
#include "sim/auction/command.hpp"
#include "sim/certificate/files.hpp"
#include "sim/checker/checker.hpp"
#include "sim/commands/certify_command.hpp"
#include "sim/commands/certify_run.hpp"
#include "sim/commands/diff_command.hpp"
#include "sim/commands/doctor_command.hpp"
#include "sim/commands/explain_command.hpp"
#include "sim/commands/export_command.hpp"
#include "sim/commands/plan_command.hpp"
#include "sim/commands/replay_command.hpp"
#include "sim/commands/reproduce_command.hpp"
#include "sim/commands/sim_command.hpp"
#include "sim/commands/tour_command.hpp"
#include "sim/commands/view_command.hpp"
#include "sim/commands/whatif_command.hpp"
#include "sim/launcher/launch.hpp"
#include "sim/picture/picture.hpp"
#include "sim/view/server.hpp"

namespace {

using namespace arcbid;

struct RunArguments {
  std::string config, structure, unit, up, out, faults, fault_tier;
  std::optional<std::uint32_t> agents;
  bool print_config = false, view = false, report = false, no_certificate = false;
};

Config configured(const RunArguments& arguments) {
  Config config = load_config(arguments.config);
  if (!arguments.structure.empty())
    config.structure.file = std::filesystem::absolute(arguments.structure);
  if (!config.structure.file && !(arguments.unit.empty() && arguments.up.empty()))
    throw InputError(
        "--unit and --up speak of a structure file, and neither --structure nor the config names "
        "one");
  if (!arguments.unit.empty()) config.structure.unit = arguments.unit;
  if (!arguments.up.empty()) config.structure.up = arguments.up.front();
  if (arguments.agents) {
    std::vector<Uav>& uavs = config.fleet.uavs;
    if (!uavs.empty() && *arguments.agents > uavs.size())
      throw InputError(fmt::format("--agents {}: {} names only {} UAVs in fleet.uavs",
                                   *arguments.agents, arguments.config, uavs.size()));
    if (!uavs.empty()) uavs.resize(*arguments.agents);
    config.fleet.agents = *arguments.agents;
  }
  validate(config);
  return config;
}

/// runs/NAME-20260131-142501-4711: distinct even when two runs begin in one second.
std::filesystem::path new_run_directory(const std::string& name) {
  const std::time_t now = std::time(nullptr);
  char stamp[32];
  std::strftime(stamp, sizeof stamp, "%Y%m%d-%H%M%S", std::localtime(&now));
  return std::filesystem::path("runs") / fmt::format("{}-{}-{}", name, stamp, getpid());
}

std::filesystem::path programs() {
  return std::filesystem::read_symlink("/proc/self/exe").parent_path();
}

/// A run is good without its picture.
void report_if_built(const std::filesystem::path& out) {
  try {
    write_report(out, programs(), out / "report.html");
  } catch (const InputError& error) {
    fmt::print(stderr, "no report: {}\n", error.what());
  }
}

/// Whether routes keep their distance; a run that came to none has its own exit code.
bool certify(const std::filesystem::path& out) {
  try {
    const certificate::Certificate result = certify_run(out, {});
    fmt::print("{}", certificate::table(result));
    return result.keeps_clear();
  } catch (const InputError& error) {
    fmt::print(stderr, "no certificate: {}\n", error.what());
    return true;
  }
}

Exit run(const RunArguments& arguments) {
  const Config config = configured(arguments);
  if (arguments.print_config) {
    fmt::print("{}", to_yaml(config));
    return Exit::done;
  }
  const std::filesystem::path out =
      arguments.out.empty() ? new_run_directory(config.name) : std::filesystem::path(arguments.out);
  std::optional<FaultSchedule> faults;
  if (!arguments.faults.empty()) faults = load_faults(arguments.faults, fleet_ids(config));
  const FaultTier tier = arguments.fault_tier == name_of(FaultTier::packets) ? FaultTier::packets
                                                                             : FaultTier::messages;
  std::atomic<bool> is_over = false;
  std::optional<ViewServer> viewer;
  if (arguments.view) {
    viewer.emplace(std::filesystem::absolute(out), programs(), 0, [&is_over] { return !is_over; });
    fmt::print("the run is seen at {} until Ctrl-C\n", viewer->address());
    std::fflush(stdout);
  }
  Exit exit = launch({config, std::filesystem::absolute(out), faults, tier, programs()});
  if (!arguments.no_certificate && exit != Exit::bad_input && !stop_requested() && !certify(out) &&
      exit == Exit::done)
    exit = Exit::check_failed;
  is_over = true;
  if (arguments.report && exit != Exit::bad_input) report_if_built(out);
  while (viewer && exit != Exit::bad_input && !stop_requested())
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  return exit;
}

Exit check_again(const std::string& directory) {
  const CheckReport report = check_run(directory);
  fmt::print("{}\n", to_json(report));
  return report.all_done() ? Exit::done : Exit::check_failed;
}

CLI::App* add_run(CLI::App& app, RunArguments& arguments) {
  CLI::App* run = app.add_subcommand(
      "run",
      "launch a coordinator and one process per agent on this machine, until every arc is "
      "allocated and every route is checked");
  run->add_option("config", arguments.config,
                  "YAML file, e.g. configs/demo.yaml; docs/CONFIG.md has every key")
      ->required();
  run->add_option("--agents", arguments.agents,
                  "fleet size instead of the config's; of fleet.uavs the first ones")
      ->type_name("N")
      ->check(CLI::Range(1, 64));
  run->add_option("--structure", arguments.structure,
                  "point cloud or mesh instead of the config's: pcd, ply, obj, stl, las, xyz")
      ->check(CLI::ExistingFile);
  run->add_option("--unit", arguments.unit, "unit of that file: m, cm, mm, ft, us-ft, in")
      ->check(CLI::IsMember({"m", "cm", "mm", "ft", "us-ft", "in"}));
  run->add_option("--up", arguments.up, "axis that points up in that file: x, y, z")
      ->check(CLI::IsMember({"x", "y", "z"}));
  run->add_option("--out", arguments.out, "run directory (default: a new one under runs/)");
  CLI::Option* faults = run->add_option(
      "--faults", arguments.faults,
      "what goes wrong: a fault file, or a preset such as lossy_30 (docs/FAULTS.md)");
  run->add_option("--fault-tier", arguments.fault_tier,
                  "what the faults of links act on: messages (default), or packets, under DDS")
      ->check(CLI::IsMember({"messages", "packets"}))
      ->needs(faults);
  run->add_flag("--view", arguments.view, "serve the viewer meanwhile, and until Ctrl-C");
  run->add_flag("--report", arguments.report, "end by writing the viewer with the run in it");
  run->add_flag("--no-certificate", arguments.no_certificate,
                "do not measure what the routes see and how near they come");
  run->add_flag("--print-config", arguments.print_config,
                "print the config as it would run, and stop");
  return run;
}

}  // namespace

int main(int argc, char** argv) {
  stop_on_signals();
  CLI::App app{
      "arcbid: inspection drones that divide a structure's arcs by auction, without a leader.\n"
      "Exit codes: 0 done and checked, 1 the run failed or its check did, 2 bad input.",
      "arcbid"};
  app.set_version_flag("--version", ARCBID_VERSION);
  app.require_subcommand(1);
  RunArguments arguments;
  const CLI::App* run_command = add_run(app, arguments);
  std::string directory;
  CLI::App* check_command =
      app.add_subcommand("check", "check a run directory again with the independent checker");
  check_command->add_option("run", directory, "run directory")
      ->required()
      ->check(CLI::ExistingDirectory);
  CLI::App* picture_command =
      app.add_subcommand("picture", "draw a run's routes as an SVG file on standard output");
  picture_command->add_option("run", directory, "run directory")
      ->required()
      ->check(CLI::ExistingDirectory);
  const AuctionCommand auction(app);
  const SimCommand sim(app);
  const ReplayCommand replay(app);
  const ExplainCommand explain(app);
  const DiffCommand diff(app);
  const WhatIfCommand what_if(app);
  const ViewCommand view(app);
  const ExportCommand export_run(app);
  const DoctorCommand doctor(app);
  const PlanCommand plan(app);
  const CertifyCommand certify_again(app);
  const TourCommand tour(app);
  const ReproduceCommand reproduce(app);
  CLI::App* reference_command =
      app.add_subcommand("config-reference", "print every key of a config, its range and default");
  return run_command_line(app, argc, argv, [&] {
    if (run_command->parsed()) return run(arguments);
    if (auction.parsed()) return auction.run();
    if (sim.parsed()) return sim.run();
    if (replay.parsed()) return replay.run(programs());
    if (explain.parsed()) return explain.run();
    if (diff.parsed()) return diff.run();
    if (what_if.parsed()) return what_if.run();
    if (view.parsed()) return view.run(programs());
    if (export_run.parsed()) return export_run.run();
    if (doctor.parsed()) return doctor.run();
    if (plan.parsed() || certify_again.parsed() || reproduce.parsed()) {
      // There is nothing to be brought to an end: what they leave is whole or not there.
      std::signal(SIGINT, SIG_DFL);
      std::signal(SIGTERM, SIG_DFL);
      if (reproduce.parsed()) return reproduce.run();
      return plan.parsed() ? plan.run() : certify_again.run();
    }
    if (tour.parsed()) return tour.run();
    if (check_command->parsed()) return check_again(directory);
    if (picture_command->parsed()) fmt::print("{}", draw_routes(directory));
    if (reference_command->parsed()) fmt::print("{}", config_reference());
    return Exit::done;
  });
}
