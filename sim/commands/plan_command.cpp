// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/commands/plan_command.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "core/base/digest.hpp"
#include "core/base/error.hpp"
#include "core/io/mission/mission_plan.hpp"
#include "core/io/process/process.hpp"
#include "core/io/run/run_files.hpp"
#include "core/route/make_transit.hpp"
#include "sim/auction/spread.hpp"
#include "sim/certificate/files.hpp"
#include "sim/checker/checker.hpp"
#include "sim/commands/certify_run.hpp"
#include "sim/commands/claim.hpp"
#include "sim/picture/picture.hpp"
#include "sim/world/world_log.hpp"

namespace arcbid {
namespace {

using nlohmann::json;

/// Says how far it is, on standard error.
class Clock {
 public:
  double seconds() const { return static_cast<double>(monotonic_ns() - start_ns_) * 1e-9; }
  void tell(const std::string& line) const {
    fmt::print(stderr, "{:7.2f} s  {}\n", seconds(), line);
  }

 private:
  TimeNs start_ns_ = monotonic_ns();
};

/// The auction without processes: a world in which nothing goes wrong, left on record like a run.
WorldResult hold_auction(const Mission& mission, const std::filesystem::path& out) {
  constexpr Range<TimeNs> latency_ns{100'000, 5'000'000};
  const WorldSpec spec{.seed = 1,
                       .mission = mission,
                       .faults = {},
                       .latency_ns = latency_ns,
                       .transit = make_transit(mission),
                       .compares_with_greedy = false};
  WorldLog log(spec, out);
  const WorldResult result = run_world(spec, {}, &log);
  log.write_result(result);
  return result;
}

/// What a run's result.json says, of a plan: the checker's figures beside the world's.
json result_of(const WorldResult& world, const CheckReport& report,
               const std::vector<std::string>& warnings, std::size_t fleet) {
  json agents = json::array();
  for (const AgentFigures& figures : report.per_agent)
    agents.push_back({{"agent", figures.agent},
                      {"arcs", figures.arcs},
                      {"tasks", figures.tasks},
                      {"length_m", figures.length_m},
                      {"time_s", figures.time_s}});
  const double agreed_s = static_cast<double>(world.agreed_ns) * 1e-9;
  return {{"schema", 1},
          {"agents", report.agents},
          {"fleet", fleet},
          {"arcs", report.arcs},
          {"tasks", report.tasks},
          {"agreement",
           {{"reached", world.agreed},
            {"time_s", agreed_s},
            {"auction_s", agreed_s},
            {"rounds", world.rounds}}},
          {"checks",
           {{"conflict_free", report.conflict_free},
            {"complete", report.complete},
            {"arcs_conserved", report.arcs_conserved},
            {"routes_valid", report.routes_valid}}},
          {"makespan_s", report.makespan_s},
          {"total_length_m", report.total_length_m},
          {"uniformity", {{"count", report.uniformity_count}, {"time", report.uniformity_time}}},
          {"cv_time", cv_time(report)},
          {"messages",
           {{"sent", world.messages},
            {"received", world.messages},
            {"dropped", 0},
            {"bytes", world.bytes}}},
          {"per_agent", agents},
          {"processes", json::array()},
          {"faults", json::array()},
          {"problems", report.problems},
          {"no_bidders", json(no_bidders_json(report))},
          {"left_m", report.left_m()},
          {"warnings", warnings}};
}

std::string figures(const CheckReport& report) {
  return fmt::format("{:<20}{} in {} tasks, {} agents\n{:<20}{:.1f} m\n{:<20}{:.1f} s\n", "arcs",
                     report.arcs, report.tasks, report.agents, "total length",
                     report.total_length_m, "makespan", report.makespan_s);
}

}  // namespace

PlanCommand::PlanCommand(CLI::App& app)
    : command_(app.add_subcommand(
          "plan",
          "plan a structure's inspection in this one process: arcs, allocation, routes, and a "
          "certificate of what they see and how near they come")) {
  command_
      ->add_option("structure", structure_,
                   "point cloud or mesh: pcd, ply, obj, stl, las, xyz (default: the config's, or "
                   "the built-in bridge)")
      ->check(CLI::ExistingFile);
  command_->add_option("--unit", unit_, "unit of that file: m, cm, mm, ft, us-ft, in")
      ->check(CLI::IsMember({"m", "cm", "mm", "ft", "us-ft", "in"}));
  command_->add_option("--up", up_, "axis that points up in that file: x, y, z")
      ->check(CLI::IsMember({"x", "y", "z"}));
  command_
      ->add_option("--config", config_,
                   "YAML file; docs/CONFIG.md has every key (default: its defaults, pieces of "
                   "10 m)")
      ->check(CLI::ExistingFile);
  command_->add_option("--agents", agents_, "fleet size instead of the config's (default: 4)")
      ->type_name("N")
      ->check(CLI::Range(1, 64));
  command_->add_option("--sensor", sensor_, "lidar or camera, with the preset's limits")
      ->check(CLI::IsMember({"lidar", "camera"}));
  command_->add_option("--out", out_, "directory that the plan is written to; new or empty")
      ->required();
}

Config PlanCommand::config() const {
  Config config;
  // The shortest arc, which eq. 4 has for a piece, can be a metre among what fills gaps.
  config.auction.split_m = 10;
  if (!config_.empty()) config = load_config(config_);
  if (!structure_.empty()) config.structure.file = std::filesystem::absolute(structure_);
  if (!config.structure.file && !(unit_.empty() && up_.empty()))
    throw InputError("--unit and --up speak of a structure file, and none is named");
  if (!unit_.empty()) config.structure.unit = unit_;
  if (!up_.empty()) config.structure.up = up_.front();
  if (agents_) {
    std::vector<Uav>& uavs = config.fleet.uavs;
    if (!uavs.empty() && *agents_ > uavs.size())
      throw InputError(fmt::format("--agents {}: {} names only {} UAVs in fleet.uavs", *agents_,
                                   config_, uavs.size()));
    if (!uavs.empty()) uavs.resize(*agents_);
    config.fleet.agents = *agents_;
  }
  if (!sensor_.empty())
    config.coverage.sensor = sensor_ == "camera" ? camera_preset() : lidar_preset();
  validate(config);
  return config;
}

Exit PlanCommand::run() const {
  const Clock clock;
  const Config planned = config();
  const std::filesystem::path out = std::filesystem::absolute(out_);
  claim(out);
  const std::string yaml = to_yaml(planned);
  clock.tell("reading the structure, making arcs");
  // The same config gives the same plan, and so the same mission.
  const MissionPlan plan = plan_mission(planned, Digest().add(yaml).value());
  for (const std::string& warning : plan.warnings) fmt::print("note: {}\n", warning);
  clock.tell(fmt::format("{} arcs; {} agents hold their auction", plan.mission.arcs.size(),
                         plan.mission.fleet.size()));
  const WorldResult world = hold_auction(plan.mission, out);
  write_whole(out / "config.yaml", yaml);
  write_structure_file(out, plan.shown);
  clock.tell("checking the routes");
  const CheckReport report = check_run(out);
  write_whole(out / "result.json",
              result_of(world, report, plan.warnings, plan.mission.fleet.size()).dump(2) + "\n");
  write_whole(out / "routes.svg", draw_routes(out));
  const certificate::Certificate certified =
      certify_run(out, {.structure = {}, .tells_progress = true});
  clock.tell("done");
  for (const Violation& violation : world.violations)
    fmt::print("problem: the auction: {}: {}\n", violation.checker, violation.what);
  for (const std::string& problem : report.problems) fmt::print("problem: {}\n", problem);
  for (const LeftUndone& left : report.left) fmt::print("left undone: {}\n", left.text);
  fmt::print("{}{}{:<20}{}\n", figures(report), certificate::table(certified), "plan",
             out.string());
  return world.agreed && world.violations.empty() && report.all_done() && certified.keeps_clear()
             ? Exit::done
             : Exit::check_failed;
}

}  // namespace arcbid
