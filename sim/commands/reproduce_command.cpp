// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/commands/reproduce_command.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/io/process/process.hpp"
#include "core/io/run/run_files.hpp"
#include "sim/commands/claim.hpp"
#include "sim/reproduce/report.hpp"
#include "sim/reproduce/tour_sets.hpp"

namespace arcbid {
namespace {

using namespace reproduce;

/// In the paper's order, each once.
std::vector<Experiment> chosen(const std::vector<std::string>& names) {
  std::string legal = "all";
  for (const Experiment& experiment : kExperiments) legal += fmt::format(", {}", experiment.name);
  std::vector<Experiment> out;
  const auto is_named = [&](std::string_view name) { return std::ranges::count(names, name) > 0; };
  for (const Experiment& experiment : kExperiments)
    if (names.empty() || is_named("all") || is_named(experiment.name)) out.push_back(experiment);
  for (const std::string& name : names)
    if (name != "all" && !std::ranges::count(kExperiments, name, &Experiment::name))
      throw InputError(fmt::format("reproduce: '{}' is no experiment; legal: {}", name, legal));
  return out;
}

/// Whether gnuplot is there to draw them. The scripts stay, so that they can be drawn elsewhere.
bool draw_pictures(const std::vector<Finding>& findings, const std::filesystem::path& out) {
  bool is_drawn = true;
  for (const Finding& finding : findings)
    for (const Picture& picture : finding.pictures) {
      const std::string script = picture.name + ".gp";
      write_whole(out / script, gnuplot_script(picture));
      is_drawn = is_drawn && draw(out, script);
    }
  return is_drawn;
}

void write(const std::vector<Finding>& findings, const std::string& command,
           const std::filesystem::path& out) {
  const bool is_drawn = draw_pictures(findings, out);
  if (!is_drawn)
    fmt::print(
        "note: nothing is drawn, for there is no gnuplot (Debian: gnuplot-nox); the scripts "
        "are there, *.gp\n");
  write_whole(out / "report.md", markdown(findings, command, is_drawn));
  write_whole(out / "index.html", html(findings, command, out));
}

}  // namespace

ReproduceCommand::ReproduceCommand(CLI::App& app)
    : command_(app.add_subcommand("reproduce",
                                  "run the paper's experiments, and set its numbers beside ours")) {
  command_->add_option("what", what_,
                       "table1, table2, fig5, fig6, fig7, fig8, fig10, fig11, or all (default)");
  command_->add_option("--out", out_, "directory for tables, plots and report; new or empty")
      ->required();
  command_->add_option(
      "--tsplib", tsplib_,
      "directory with the instances of TSPLIB95 (G. Reinelt, 1991), NAME.tsp; NAME.matching.pairs "
      "and arc_reference.csv beside them are heeded (default: sets made here)");
  command_->add_option("--repeats", repeats_, "runs of what is random (20, as in the paper)")
      ->check(CLI::Range(1u, 1000u));
  command_->add_option("--seed", seed_, "of all that is random; the same seed, the same numbers");
  command_->add_option("--jobs", jobs_, "threads (1); but for seconds they change nothing")
      ->check(CLI::Range(1u, 256u));
}

/// The command that makes the same report, but for where it goes.
std::string ReproduceCommand::again() const {
  std::string command = "arcbid reproduce";
  for (const std::string& name : what_) command += " " + name;
  return command + fmt::format(" --repeats {} --seed {}{} --out DIR", repeats_, seed_,
                               tsplib_.empty() ? "" : " --tsplib DIR");
}

Exit ReproduceCommand::run() const {
  const std::vector<Experiment> experiments = chosen(what_);
  const TimeNs start_ns = monotonic_ns();
  Settings settings;
  settings.repeats = repeats_;
  settings.seed = seed_;
  settings.jobs = jobs_;
  settings.tell = [start_ns](const std::string& line) {
    fmt::print(stderr, "{:7.2f} s  {}\n", static_cast<double>(monotonic_ns() - start_ns) * 1e-9,
               line);
  };
  if (!tsplib_.empty()) {
    settings.tsplib = tsplib_;
    require_tsplib(*settings.tsplib);
  }
  const std::filesystem::path out = std::filesystem::absolute(out_);
  claim(out);
  std::vector<Finding> findings;
  for (const Experiment& experiment : experiments) {
    findings.push_back(experiment.run(settings));
    write_csv(findings.back().table, out / (findings.back().name + ".csv"));
    fmt::print("{:<20}{} rows\n", findings.back().name, findings.back().table.rows.size());
    std::fflush(stdout);
  }
  write(findings, again(), out);
  settings.tell("done");
  fmt::print("{:<20}{} (arcbid view {})\n", "report", (out / "report.md").string(), out_);
  return Exit::done;
}

}  // namespace arcbid
