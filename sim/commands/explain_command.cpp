// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/commands/explain_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "sim/commands/explain_report.hpp"
#include "sim/commands/tell.hpp"

namespace arcbid {
namespace {

std::vector<TaskId> tasks_of(const RunArchive& run, ArcId arc) {
  std::vector<TaskId> out;
  for (const Task& task : run.tasks.tasks)
    if (task.arc == arc) out.push_back(task.id);
  if (out.empty())
    throw InputError(fmt::format("--arc {}: {} has arcs 0 to {}", arc.value, run.directory.string(),
                                 run.mission->arcs.size() - 1));
  return out;
}

}  // namespace

ExplainCommand::ExplainCommand(CLI::App& app)
    : command_(
          app.add_subcommand("explain", "why who has what, and what would have been otherwise")) {
  command_->add_option("run", run_, "run directory")->required()->check(CLI::ExistingDirectory);
  CLI::Option_group* what = command_->add_option_group("what");
  what->add_option("--arc", arc_, "all tasks of this arc");
  what->add_option("--task", task_, "this task");
  what->add_option("--agent", agent_, "what this agent gained and lost, round by round");
  what->require_option(1);
  command_->add_option("--json", json_, "write it as JSON to this file (-: to the output)");
}

Exit ExplainCommand::run() const {
  const RunArchive run = open_run(run_);
  tell_unverifiable(run);
  if (task_ && *task_ >= run.tasks.tasks.size())
    throw InputError(
        fmt::format("--task {}: {} has tasks 0 to {}", *task_, run_, run.tasks.tasks.size() - 1));
  const std::vector<Uav>& fleet = run.mission->fleet;
  if (agent_ && std::none_of(fleet.begin(), fleet.end(),
                             [this](const Uav& uav) { return uav.id == AgentId{*agent_}; }))
    throw InputError(fmt::format("--agent {}: is not of the fleet of {}", *agent_, run_));
  ExplainReport report(run);
  if (agent_) report.add(AgentId{*agent_});
  if (task_) report.add(TaskId{*task_});
  if (arc_)
    for (const TaskId task : tasks_of(run, ArcId{*arc_})) report.add(task);
  if (json_ == "-")
    fmt::print("{}\n", report.json().dump(1));
  else
    fmt::print("{}", report.text());
  if (!json_.empty() && json_ != "-" && !(std::ofstream(json_) << report.json().dump(1) << '\n'))
    throw InputError(fmt::format("{}: cannot be written", json_));
  return Exit::done;
}

}  // namespace arcbid
