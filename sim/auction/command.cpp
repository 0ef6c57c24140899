// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/auction/command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "core/io/process/process.hpp"
#include "sim/auction/arc_instance.hpp"
#include "sim/auction/evaluate.hpp"
#include "sim/auction/fleet_run.hpp"
#include "sim/auction/rounds.hpp"

namespace arcbid {
namespace {

template <class E, std::size_t n>
std::map<std::string, E> by_name(const std::array<std::string_view, n>& names) {
  std::map<std::string, E> out;
  for (std::size_t i = 0; i < n; ++i) out.emplace(names[i], static_cast<E>(i));
  return out;
}

const std::map<std::string, Graph> graphs{{"complete", Graph::complete},
                                          {"ring", Graph::ring},
                                          {"line", Graph::line},
                                          {"star", Graph::star}};

nlohmann::json to_json(const RoundsOutcome& outcome, const Evaluation& value, double cpu) {
  nlohmann::json paths = nlohmann::json::array();
  for (const auto& path : outcome.paths) {
    nlohmann::json tasks = nlohmann::json::array();
    for (const TaskId task : path) tasks.push_back(task.value);
    paths.push_back(tasks);
  }
  return {{"paths", paths},
          {"last_change_round", outcome.last_change_round},
          {"proof_round", outcome.proof_round},
          {"converged", outcome.converged},
          {"messages", outcome.messages},
          {"sends", outcome.sends},
          {"bytes", outcome.bytes},
          {"bytes_as_differences", outcome.difference_bytes},
          {"bytes_as_orders",
           outcome.order_bytes > 0 ? nlohmann::json(outcome.order_bytes) : nlohmann::json(nullptr)},
          {"agreed", outcome.agreed},
          {"conflicts", value.conflicts},
          {"assigned", value.assigned},
          {"score", value.score},
          {"sum_length_m", value.sum_length_m},
          {"makespan_s", value.makespan_s},
          {"cpu_s", cpu}};
}

void print_table(const RoundsOutcome& outcome, const Evaluation& value, double cpu) {
  const auto line = [](const char* name, const std::string& text) {
    fmt::print("{:<20}{}\n", name, text);
  };
  line("converged", outcome.converged ? "yes" : "no: cut off while it still changed");
  line("agreed", outcome.agreed ? "yes" : "no");
  line("last change", fmt::format("round {}", outcome.last_change_round));
  if (outcome.proof_round > 0) line("proven", fmt::format("round {}", outcome.proof_round));
  line("messages",
       fmt::format(
           "{} ({} sends, {} bytes; {} as differences{})", outcome.messages, outcome.sends,
           outcome.bytes, outcome.difference_bytes,
           outcome.order_bytes > 0 ? fmt::format(", {} as orders", outcome.order_bytes) : ""));
  line("assigned", fmt::format("{}, {} to more than one agent", value.assigned, value.conflicts));
  line("score", fmt::format("{:.6f}", value.score));
  line("length",
       fmt::format("{:.1f} m, slowest agent {:.1f} s", value.sum_length_m, value.makespan_s));
  line("CPU", fmt::format("{:.4f} s", cpu));
}

}  // namespace

struct AuctionCommand::Arguments {
  std::string agents, tasks, values = "unit", json, instance;
  TradesKind trades = TradesKind::full;
  double split_m = 0;
  AuctionSettings settings;
  Graph graph = Graph::complete;
  bool orders = false;
};

AuctionCommand::AuctionCommand(CLI::App& app) : arguments_(std::make_unique<Arguments>()) {
  Arguments& a = *arguments_;
  a.settings.score = ScoreKind::discounted_append;
  CLI::App* command = app.add_subcommand(
      "auction", "run one instance in synchronous rounds, all agents in one thread");
  auto* points = command->add_option("--agents", a.agents, "points: CSV: agent,x,y,z,speed")
                     ->check(CLI::ExistingFile);
  points->needs(
      command->add_option("--tasks", a.tasks, "points: CSV: task,x,y,z,value_unit,value_weighted")
          ->check(CLI::ExistingFile));
  add_arc_options(*command, *points);
  command->add_option("--values", a.values, "which value column: unit, weighted")
      ->check(CLI::IsMember({"unit", "weighted"}));
  command->add_option("--policy", a.settings.policy, "how agents come to agree")
      ->transform(CLI::CheckedTransformer(by_name<PolicyKind>(policy_names)));
  command->add_option("--score", a.settings.score, "what a task is worth to an agent")
      ->transform(CLI::CheckedTransformer(by_name<ScoreKind>(score_names)));
  command->add_option("--graph", a.graph, "who hears whom")
      ->transform(CLI::CheckedTransformer(graphs));
  command->add_option("--bundle-limit", a.settings.bundle_limit,
                      "most tasks an agent takes (0: no limit)");
  command->add_option("--discount", a.settings.discount_per_s, "rate of the discounted scores, 1/s")
      ->check(CLI::Range(1e-6, 10.0));
  command->add_flag("--orders", a.orders,
                    "claims: also count the bytes of statements without bids, which costs CPU");
  command->add_option("--json", a.json, "write the result as JSON to this file (-: to the output)");
  command_ = command;
}

AuctionCommand::~AuctionCommand() = default;

bool AuctionCommand::parsed() const {
  return command_->parsed();
}

/// Arcs, home to home.
void AuctionCommand::add_arc_options(CLI::App& command, CLI::Option& points) {
  Arguments& a = *arguments_;
  auto* arcs = command
                   .add_option("--instance", a.instance,
                               "arcs: JSON with agents and arcs; prints one JSON object")
                   ->check(CLI::ExistingFile)
                   ->excludes(&points);
  command
      .add_option("--trades", a.trades,
                  "arcs: what is exchanged after the auction: off, cheap, full")
      ->transform(CLI::CheckedTransformer(by_name<TradesKind>(trades_names)))
      ->needs(arcs);
  command.add_option("--split", a.split_m, "arcs: piece length in m (0: the arcs as they are)")
      ->check(CLI::Range(0.0, 1e6))
      ->needs(arcs);
}

Exit AuctionCommand::run_arcs() const {
  const Arguments& a = *arguments_;
  Mission mission = read_arc_instance(a.instance);
  mission.auction = a.settings;
  if (command_->get_option("--score")->empty())
    mission.auction.score = ScoreKind::minimax_long_first;
  mission.auction.split_m = a.split_m > 0 ? a.split_m : 1e9;
  const FleetRun run = run_fleet(mission, a.graph, a.trades);
  if (a.json.empty() || a.json == "-")
    fmt::print("{}\n", to_json(run));
  else if (!(std::ofstream(a.json) << to_json(run) << '\n'))
    throw InputError(fmt::format("{}: cannot be written", a.json));
  const bool whole = std::ranges::all_of(
      run.left, [](const NoBidder& left) { return left.why == NoBidderReason::bundle_limit; });
  return run.converged && run.agreed && whole ? Exit::done : Exit::check_failed;
}

Exit AuctionCommand::run() const {
  const Arguments& a = *arguments_;
  if (!a.instance.empty()) return run_arcs();
  if (a.agents.empty())
    throw InputError("auction: needs --agents and --tasks (points) or --instance (arcs)");
  const Instance instance = read_instance(a.agents, a.tasks, "value_" + a.values);
  const double before = thread_cpu_s();
  const RoundsOutcome outcome =
      run_rounds(instance, a.settings, a.graph, a.orders ? Encoding::orders : Encoding::bids);
  const double cpu = thread_cpu_s() - before;
  const Evaluation value = evaluate(instance, outcome.paths, a.settings.discount_per_s);
  if (a.json == "-") {
    fmt::print("{}\n", to_json(outcome, value, cpu).dump());
  } else {
    print_table(outcome, value, cpu);
    if (!a.json.empty() && !(std::ofstream(a.json) << to_json(outcome, value, cpu).dump() << '\n'))
      throw InputError(fmt::format("{}: cannot be written", a.json));
  }
  return outcome.converged && outcome.agreed && value.conflicts == 0 ? Exit::done
                                                                     : Exit::check_failed;
}

}  // namespace arcbid
