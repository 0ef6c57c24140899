// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/auction/command.hpp"

#include <fmt/format.h>

#include <ctime>
#include <fstream>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "sim/auction/evaluate.hpp"
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

/// CPU time of this thread, seconds.
double cpu_s() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

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
  std::string agents, tasks, values = "unit", json;
  AuctionSettings settings;
  Graph graph = Graph::complete;
  bool orders = false;
};

AuctionCommand::AuctionCommand(CLI::App& app) : arguments_(std::make_unique<Arguments>()) {
  Arguments& a = *arguments_;
  a.settings.score = ScoreKind::discounted_append;
  CLI::App* command = app.add_subcommand(
      "auction", "run one instance of point tasks in synchronous rounds, all agents in one thread");
  command->add_option("--agents", a.agents, "CSV: agent,x,y,z,speed")
      ->required()
      ->check(CLI::ExistingFile);
  command->add_option("--tasks", a.tasks, "CSV: task,x,y,z,value_unit,value_weighted")
      ->required()
      ->check(CLI::ExistingFile);
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

Exit AuctionCommand::run() const {
  const Arguments& a = *arguments_;
  const Instance instance = read_instance(a.agents, a.tasks, "value_" + a.values);
  const double before = cpu_s();
  const RoundsOutcome outcome =
      run_rounds(instance, a.settings, a.graph, a.orders ? Encoding::orders : Encoding::bids);
  const double cpu = cpu_s() - before;
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
