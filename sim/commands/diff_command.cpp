// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/commands/diff_command.hpp"

#include <fmt/format.h>

#include "sim/commands/tell.hpp"
#include "sim/replay/diff.hpp"

namespace arcbid {
namespace {

std::string shown(const std::optional<double>& value) {
  return value ? fmt::format("{:.3f}", *value) : "-";
}

void print(const RunDiff::Parting& parting) {
  const auto bid = [](const std::optional<double>& value) {
    return value ? fmt::format("bids {}", *value) : std::string("does not bid");
  };
  fmt::print("they part in round {} of agent {}: for task {} it {} ({:.6f} s) and {} ({:.6f} s)\n",
             parting.round, parting.agent.value, parting.task.value, bid(parting.bid[0]),
             static_cast<double>(parting.t_ns[0]) * 1e-9, bid(parting.bid[1]),
             static_cast<double>(parting.t_ns[1]) * 1e-9);
  for (const std::string& line : parting.before) fmt::print("  {}\n", line);
  if (parting.before.empty()) fmt::print("  it held the same of all others\n");
}

void print_owners(const RunDiff& found, const OpenRun& a, const OpenRun& b) {
  const auto owner = [](const OpenRun& run, TaskId task) {
    const auto& winner = run.explainer.owners()[task.value].winner;
    return winner ? fmt::format("agent {}", winner->value) : std::string("nobody");
  };
  fmt::print("{} of {} tasks have another owner\n", found.owners.size(), a.run.tasks.tasks.size());
  for (const TaskId task : found.owners)
    fmt::print("  task {} (arc {}): {} and {}\n", task.value,
               a.run.tasks.tasks[task.value].arc.value, owner(a, task), owner(b, task));
}

}  // namespace

DiffCommand::DiffCommand(CLI::App& app)
    : command_(app.add_subcommand(
          "diff", "where two runs part, and what it cost (exit code 0: the same allocation)")) {
  command_->add_option("first", first_, "run directory")->required()->check(CLI::ExistingDirectory);
  command_->add_option("second", second_, "run directory")
      ->required()
      ->check(CLI::ExistingDirectory);
}

Exit DiffCommand::run() const {
  const OpenRun a(first_), b(second_);
  tell_unverifiable(a.run);
  tell_unverifiable(b.run);
  const RunDiff found = diff(a, b);
  fmt::print("{}\n", found.settings.empty() ? "the same mission" : "not the same mission");
  for (const std::string& line : found.settings) fmt::print("  {}\n", line);
  if (!found.same_tasks)
    fmt::print("not the same tasks: their owners cannot be compared\n");
  else if (found.parting)
    print(*found.parting);
  else
    fmt::print("no agent decided otherwise in any round that both have\n");
  if (found.same_tasks) print_owners(found, a, b);
  fmt::print("{:<22}{:>16}{:>16}{:>16}\n", "", "first", "second", "difference");
  for (const RunDiff::Figure& figure : found.figures) {
    const auto& [first, second] = figure.value;
    const auto by = first && second ? std::optional(*second - *first) : std::nullopt;
    fmt::print("{:<22}{:>16}{:>16}{:>16}\n", figure.name, shown(first), shown(second), shown(by));
  }
  return found.same_allocation() ? Exit::done : Exit::check_failed;
}

}  // namespace arcbid
