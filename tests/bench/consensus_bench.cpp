// SPDX-License-Identifier: GPL-3.0-or-later
// What consensus costs, all agents in one thread: CPU beside an independent implementation's, and
// messages and bytes until the last change (claims: until proven) for every policy and graph.
//
//   consensus_bench [FOLDER]   tables in Markdown on standard output; with FOLDER also traffic.tsv
//                              there, from which traffic.gp draws traffic.svg
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "sim/auction/rounds.hpp"
#include "tests/rounds/points.hpp"

namespace {

using namespace arcbid;

const std::filesystem::path folder = std::filesystem::path(ARCBID_SHARED_DATA) / "cbba";
const std::array<std::pair<const char*, Graph>, 3> graphs{
    {{"complete", Graph::complete}, {"ring", Graph::ring}, {"line", Graph::line}}};

Graph graph_of(const std::string& name) {
  for (const auto& [known, graph] : graphs)
    if (name == known) return graph;
  return Graph::complete;
}

double cpu_s() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The least of three runs: what else the machine does only adds.
double least_cpu_s(const Instance& instance, const AuctionSettings& settings, Graph graph) {
  double least = 1e9;
  for (int run = 0; run < 3; ++run) {
    const double start = cpu_s();
    run_rounds(instance, settings, graph);
    least = std::min(least, cpu_s() - start);
  }
  return least;
}

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> out;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');) out.push_back(cell);
  return out;
}

std::uint32_t bundle_limit(const Instance& instance) {
  const double share =
      static_cast<double>(instance.tasks.tasks.size()) / static_cast<double>(instance.fleet.size());
  return static_cast<std::uint32_t>(std::ceil(1.2 * share));
}

void cpu_table() {
  std::ifstream file(folder / "ref_cpu.csv");
  if (!file) {
    fmt::print("{} (third-party data) is not here: no CPU table\n", folder.string());
    return;
  }
  const std::map<std::string, ScoreKind> scores{{"MOD", ScoreKind::independent},
                                                {"TDA", ScoreKind::discounted_append},
                                                {"TDI", ScoreKind::discounted_insert}};
  fmt::print("| instance | score | graph | reference, s | cbba, s | of it | claims, s | of it |\n");
  fmt::print("|---|---|---|---:|---:|---:|---:|---:|\n");
  for (std::string line; std::getline(file, line);) {
    const auto row = cells(line);
    const Instance instance =
        read_instance(folder / "instances" / (row[0] + "_agents.csv"),
                      folder / "instances" / (row[0] + "_tasks.csv"), "value_unit");
    AuctionSettings settings;
    settings.bundle_limit = bundle_limit(instance);
    settings.score = scores.at(row[1]);
    settings.policy = PolicyKind::cbba;
    const double reference = std::stod(row[4]);
    const double cbba = least_cpu_s(instance, settings, graph_of(row[2]));
    settings.policy = PolicyKind::claims;
    if (row[1] == "TDI") settings.score = ScoreKind::discounted_insert_warped;
    const double claims = least_cpu_s(instance, settings, graph_of(row[2]));
    fmt::print("| {} | {} | {} | {:.3f} | {:.3f} | {:.0f} % | {:.3f} | {:.0f} % |\n", row[0],
               row[1], row[2], reference, cbba, 100 * cbba / reference, claims,
               100 * claims / reference);
  }
}

void traffic_table(std::ofstream& tsv) {
  fmt::print(
      "\n| agents | tasks | graph | policy | rounds | proof | messages | kB | kB, differences | "
      "kB, orders |\n");
  fmt::print("|---:|---:|---|---|---:|---:|---:|---:|---:|---:|\n");
  for (const std::uint32_t tasks : {100u, 500u, 1000u})
    for (const std::uint32_t agents : {2u, 4u, 8u, 16u, 32u, 64u}) {
      const Instance instance = testing::random_points(agents * 10000 + tasks, agents, tasks);
      for (const auto& [name, graph] : graphs)
        for (std::size_t p = 0; p < policy_names.size(); ++p) {
          AuctionSettings settings;
          settings.policy = static_cast<PolicyKind>(p);
          settings.score = ScoreKind::discounted_append;
          settings.bundle_limit = bundle_limit(instance);
          const RoundsOutcome o = run_rounds(instance, settings, graph, Encoding::orders);
          const std::string rounds = o.converged ? fmt::format("{}", o.last_change_round) : "never";
          fmt::print(
              "| {} | {} | {} | {} | {} | {} | {} | {:.1f} | {:.1f} | {} |\n", agents, tasks, name,
              policy_names[p], rounds, o.proof_round > 0 ? fmt::format("{}", o.proof_round) : "",
              o.messages, 1e-3 * static_cast<double>(o.bytes),
              1e-3 * static_cast<double>(o.difference_bytes),
              o.order_bytes > 0 ? fmt::format("{:.1f}", 1e-3 * static_cast<double>(o.order_bytes))
                                : "");
          if (o.converged)
            tsv << fmt::format("{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\n", agents, tasks, name,
                               policy_names[p], o.messages, o.bytes, o.difference_bytes,
                               o.order_bytes);
        }
    }
}

}  // namespace

int main(int argc, char** argv) {
  std::ofstream tsv;
  if (argc > 1) tsv.open(std::filesystem::path(argv[1]) / "traffic.tsv");
  cpu_table();
  traffic_table(tsv);
}
