// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/commands/sim_command.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <fstream>
#include <optional>
#include <thread>

#include "core/io/faults/fault_files.hpp"
#include "core/io/process/process.hpp"
#include "sim/commands/choices.hpp"
#include "sim/commands/summary.hpp"
#include "sim/world/batch.hpp"
#include "sim/world/live_run.hpp"
#include "sim/world/settings_file.hpp"
#include "sim/world/shrink.hpp"
#include "sim/world/world_log.hpp"

namespace arcbid {
namespace {

constexpr std::size_t most_shown = 20;  // violations in full

}  // namespace

struct SimCommand::Arguments {
  std::string config, run, seeds = "1..1000", json, policy, score, faults, record;
  std::optional<double> loss;
  std::optional<std::uint32_t> agents, tasks;
  unsigned jobs = std::max(1u, std::thread::hardware_concurrency());
  bool trace = false, shrinks = false;

  WorldSettings settings() const;
  Worlds worlds() const;
  bool reports_on_output() const { return json != "-"; }
  std::string repeat(std::uint64_t seed) const;
};

WorldSettings SimCommand::Arguments::settings() const {
  WorldSettings out = load_worlds(config);
  if (!policy.empty()) out.policies = {by_name<PolicyKind>(policy_names, policy)};
  if (!score.empty()) out.scores = {by_name<ScoreKind>(score_names, score)};
  if (agents) out.agents = {*agents, *agents};
  if (tasks) out.tasks = {*tasks, *tasks};
  if (loss) {
    out.odds = {};
    out.odds[static_cast<std::size_t>(WorldFault::loss)] = *loss > 0 ? 1 : 0;
    out.loss = {*loss, *loss};
  }
  return out;
}

/// Those of a config, or the one world of a live run, whose messages take other times by the seed.
Worlds SimCommand::Arguments::worlds() const {
  if (config.empty() == run.empty())
    throw InputError("CONFIG or --run RUN: one of the two says which worlds");
  if (run.empty()) return worlds_of(settings());
  const LiveRun live = read_run(run);
  const WorldSpec world = world_of(live, 1);
  if (reports_on_output()) {
    for (const std::string& line : live.left_out) fmt::print("left out: {}\n", line);
    fmt::print("{}: mission {:016x}, digest {:016x}: {}\n", run, world.mission.id,
               digest(world.mission), summary(world));
  }
  return {[world](std::uint64_t seed) {
            WorldSpec spec = world;
            spec.seed = seed;
            return spec;
          },
          true};
}

/// The command line that shows one world again, bit for bit.
std::string SimCommand::Arguments::repeat(std::uint64_t seed) const {
  const std::string& worlds = run.empty() ? config : "--run " + run;
  std::string line = fmt::format("arcbid sim {} --seeds {} --trace", worlds, seed);
  if (!policy.empty()) line += " --policy " + policy;
  if (!score.empty()) line += " --score " + score;
  if (agents) line += fmt::format(" --agents {}", *agents);
  if (tasks) line += fmt::format(" --tasks {}", *tasks);
  if (loss) line += fmt::format(" --loss {}", *loss);
  return line;
}

SimCommand::SimCommand(CLI::App& app) : arguments_(std::make_unique<Arguments>()) {
  Arguments& a = *arguments_;
  CLI::App* smaller = app.add_subcommand(
      "shrink", "reduce a failing world to the fewest faults, agents and arcs that still fail");
  smaller->add_option("config", a.config, "YAML file of the worlds");
  CLI::Option* failed = smaller->add_option("--run", a.run, "as for sim");
  smaller->add_option("--seed", a.seeds, "the failing world")->required();
  smaller->add_option("--policy", a.policy, "as for sim")->excludes(failed);
  smaller->add_option("--score", a.score, "as for sim")->excludes(failed);
  smaller->add_option("--faults", a.faults,
                      "write what is left of the fault schedule to this file, "
                      "for arcbid run --faults");
  shrink_ = smaller;
  CLI::App* sim = app.add_subcommand(
      "sim",
      "run seeded worlds in virtual time, everything mixed that can go wrong, and check "
      "every step");
  sim->add_option("config", a.config, "YAML file, e.g. configs/sim.yaml; docs/SIMULATOR.md");
  CLI::Option* live = sim->add_option(
      "--run", a.run,
      "directory of a live run: its mission, and what went wrong in it, when it did");
  sim->add_option("--seeds", a.seeds, "which worlds: SEED or FIRST..LAST");
  sim->add_option("--jobs", a.jobs, "threads")->check(CLI::Range(1, 256));
  sim->add_option("--json", a.json, "write the figures to this file (-: to the output)");
  sim->add_option("--policy", a.policy, "this policy instead of the config's")->excludes(live);
  sim->add_option("--score", a.score, "this score instead of the config's")->excludes(live);
  sim->add_option("--agents", a.agents, "fleet size instead of the config's")
      ->excludes(live)
      ->check(CLI::Range(1, 64));
  sim->add_option("--tasks", a.tasks, "tasks instead of the config's")
      ->excludes(live)
      ->check(CLI::Range(1, 1000));
  sim->add_option("--loss", a.loss, "independent loss on every link instead of the config's faults")
      ->excludes(live)
      ->check(CLI::Range(0.0, 1.0));
  sim->add_option("--export-faults", a.faults,
                  "write the world's fault schedule to this file, for arcbid run --faults");
  sim->add_option("--record", a.record,
                  "leave the world on record in this directory, for replay and view (one world)");
  sim->add_flag("--trace", a.trace, "print everything that happens (one world)");
  command_ = sim;
}

SimCommand::~SimCommand() = default;

bool SimCommand::parsed() const {
  return command_->parsed() || shrink_->parsed();
}

/// A schedule that live processes can be run under.
void SimCommand::write_faults(const WorldSpec& spec) const {
  if (arguments_->faults.empty()) return;
  if (!(std::ofstream(arguments_->faults) << to_yaml(spec.faults)))
    throw InputError(fmt::format("{}: cannot be written", arguments_->faults));
}

Exit SimCommand::run_shrink() const {
  const Arguments& a = *arguments_;
  const Seeds seeds = seeds_of(a.seeds);
  if (seeds.first != seeds.last) throw InputError("--seed: is one seed");
  const WorldSpec spec = a.worlds().make(seeds.first);
  const WorldResult result = run_world(spec);
  if (result.violations.empty())
    throw InputError(fmt::format("--seed {}: this world has no violation", seeds.first));
  const std::string checker = result.violations.front().checker;
  const WorldSpec small = shrink(spec, [&](const WorldSpec& world) {
    const WorldResult again = run_world(world);
    return !again.violations.empty() && again.violations.front().checker == checker;
  });
  fmt::print("{}\nshrunk to\n{}\n", summary(spec), summary(small));
  for (const Uav& uav : small.mission.fleet)
    fmt::print("agent {} at ({:.3f}, {:.3f}, {:.3f}) m, {:.3f} m/s\n", uav.id.value, uav.home_m.x(),
               uav.home_m.y(), uav.home_m.z(), uav.speed_mps);
  for (const Arc& arc : small.mission.arcs) {
    const Vec3 &p = arc.waypoints.front().position_m, &q = arc.waypoints.back().position_m;
    fmt::print("arc {} from ({:.3f}, {:.3f}, {:.3f}) to ({:.3f}, {:.3f}, {:.3f}) m\n", arc.id.value,
               p.x(), p.y(), p.z(), q.x(), q.y(), q.z());
  }
  fmt::print("{}", to_yaml(small.faults));
  run_world(small, [](const std::string& line) { fmt::print("{}\n", line); });
  write_faults(small);
  return Exit::check_failed;
}

Exit SimCommand::run_one(const WorldSpec& spec) const {
  const Arguments& a = *arguments_;
  std::optional<WorldLog> log;
  if (!a.record.empty()) log.emplace(spec, a.record);
  fmt::print("{}\n", summary(spec));
  const Trace trace = [](const std::string& line) { fmt::print("{}\n", line); };
  const WorldResult result = run_world(spec, a.trace ? trace : Trace(), log ? &*log : nullptr);
  if (log) log->write_result(result);
  if (!a.trace)
    fmt::print("{}, {} steps, makespan {:.1f} s: {}\n", result.agreed ? "agreed" : "not agreed",
               result.steps, result.makespan_s, a.record);
  return result.violations.empty() ? Exit::done : Exit::check_failed;
}

Exit SimCommand::run() const {
  if (shrink_->parsed()) return run_shrink();
  const Arguments& a = *arguments_;
  const Seeds seeds = seeds_of(a.seeds);
  if ((a.trace || !a.faults.empty() || !a.record.empty()) && seeds.first != seeds.last)
    throw InputError("--trace, --record and --export-faults: are for one seed");
  const Worlds worlds = a.worlds();
  write_faults(worlds.make(seeds.first));
  if (a.trace || !a.record.empty()) return run_one(worlds.make(seeds.first));
  SimSummary figures;
  const TimeNs start_ns = monotonic_ns();
  const bool terminal = isatty(STDERR_FILENO) != 0;
  const std::uint64_t all = seeds.last - seeds.first + 1;
  run_batch(worlds, seeds.first, seeds.last, a.jobs, [&](const PricedResult& result) {
    figures.add(result);
    if (!result.world.violations.empty() && figures.violations() <= most_shown) {
      const Violation& first = result.world.violations.front();
      fmt::print("seed {}: {}: {}\n  again: {}\n", result.world.seed, first.checker, first.what,
                 a.repeat(result.world.seed));
    }
    if (terminal && figures.worlds() % 100 == 0)
      fmt::print(stderr, "\r{} of {} worlds, {} with violations", figures.worlds(), all,
                 figures.violations());
    return !stop_requested();
  });
  if (terminal) fmt::print(stderr, "\r\033[K");
  const double wall_s = static_cast<double>(monotonic_ns() - start_ns) * 1e-9;
  if (!a.reports_on_output())
    fmt::print("{}\n", figures.to_json(wall_s).dump(1));
  else
    fmt::print("{}", figures.table(wall_s));
  if (!a.json.empty() && a.json != "-" &&
      !(std::ofstream(a.json) << figures.to_json(wall_s).dump(1) << '\n'))
    throw InputError(fmt::format("{}: cannot be written", a.json));
  return figures.violations() == 0 && figures.worlds() == all ? Exit::done : Exit::check_failed;
}

}  // namespace arcbid
