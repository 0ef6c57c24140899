// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/commands/whatif_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <thread>

#include "core/io/process/process.hpp"
#include "sim/commands/choices.hpp"
#include "sim/world/batch.hpp"

namespace arcbid {
namespace {

/// One figure over all seeds.
using Values = std::vector<double>;
double mean(const Values& values) {
  return values.empty() ? 0
                        : std::accumulate(values.begin(), values.end(), 0.0) /
                              static_cast<double>(values.size());
}
double worst(const Values& values) {
  return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

struct Figure {
  const char* name;
  double (*of)(const WorldResult&);
};
constexpr std::array<Figure, 6> figures{{
    {"makespan s", [](const WorldResult& w) { return w.makespan_s; }},
    {"total length m", [](const WorldResult& w) { return w.total_length_m; }},
    {"time to agreement s",
     [](const WorldResult& w) { return static_cast<double>(w.agreed_ns) * 1e-9; }},
    {"rounds", [](const WorldResult& w) { return static_cast<double>(w.rounds); }},
    {"messages", [](const WorldResult& w) { return static_cast<double>(w.messages); }},
    {"kilobytes", [](const WorldResult& w) { return static_cast<double>(w.bytes) * 1e-3; }},
}};

std::vector<WorldResult> worlds_of(const WorldSpec& world, const Seeds& seeds, unsigned jobs) {
  const Worlds worlds{[&world](std::uint64_t seed) {
                        WorldSpec spec = world;
                        spec.seed = seed;
                        return spec;
                      },
                      false};
  std::vector<WorldResult> out;
  run_batch(worlds, seeds.first, seeds.last, jobs, [&out](const PricedResult& result) {
    out.push_back(result.world);
    return !stop_requested();
  });
  return out;
}

/// What the worlds came to that agreed: the others have no allocation.
Values values_of(const std::vector<WorldResult>& worlds, const Figure& figure) {
  Values out;
  for (const WorldResult& world : worlds)
    if (world.agreed) out.push_back(figure.of(world));
  return out;
}

void print(const std::vector<WorldResult>& was, const std::vector<WorldResult>& is) {
  fmt::print("{:<22}{:>14}{:>14}{:>14}{:>14}{:>14}\n", "", "as it was", "worst", "what if", "worst",
             "difference");
  for (const Figure& figure : figures) {
    const Values before = values_of(was, figure), after = values_of(is, figure);
    fmt::print("{:<22}{:>14.3f}{:>14.3f}{:>14.3f}{:>14.3f}{:>+14.3f}\n", figure.name, mean(before),
               worst(before), mean(after), worst(after), mean(after) - mean(before));
  }
  Values changed;
  for (std::size_t n = 0; n < std::min(was.size(), is.size()); ++n)
    if (was[n].agreed && is[n].agreed)
      changed.push_back(static_cast<double>(owners_changed(was[n], is[n])));
  fmt::print("tasks with another owner: {:.1f} on average, {:.0f} at worst\n", mean(changed),
             worst(changed));
  const auto agreed = [](const std::vector<WorldResult>& worlds) {
    return std::count_if(worlds.begin(), worlds.end(), [](const auto& w) { return w.agreed; });
  };
  fmt::print("worlds that agreed: {} and {} of {}\n", agreed(was), agreed(is), was.size());
}

void print_owners(const WorldResult& was, const WorldResult& is) {
  const auto owner = [](const WorldResult& world, std::size_t j) {
    const bool known = j < world.winners.size() && world.winners[j].winner;
    return known ? fmt::format("agent {}", world.winners[j].winner->value) : std::string("nobody");
  };
  if (!was.agreed || !is.agreed) return;
  for (std::size_t j = 0; j < was.winners.size(); ++j)
    if (owner(was, j) != owner(is, j))
      fmt::print("  task {}: {} instead of {}\n", j, owner(is, j), owner(was, j));
}

}  // namespace

WhatIfCommand::WhatIfCommand(CLI::App& app)
    : command_(app.add_subcommand("whatif", "a run's inputs under other rules, simulated")),
      jobs_(std::max(1u, std::thread::hardware_concurrency())) {
  command_->add_option("run", run_, "run directory")->required()->check(CLI::ExistingDirectory);
  command_->add_option("--policy", policy_, "this policy instead");
  command_->add_option("--score", score_, "this score instead");
  command_->add_option("--agents", agents_, "the first N of the fleet only")
      ->check(CLI::Range(1, 64));
  command_->add_option("--without", without_, "as if these had never been there (3 or 3,5)")
      ->delimiter(',');
  command_->add_option("--bundle-limit", bundle_limit_, "most tasks an agent takes; 0: no limit");
  command_->add_option("--loss", loss_, "independent loss on every link besides")
      ->check(CLI::Range(0.0, 1.0));
  command_->add_option(
      "--seeds", seeds_,
      "how long messages take: SEED or FIRST..LAST (default: a recorded world's own, else 1)");
  command_->add_option("--jobs", jobs_, "threads")->check(CLI::Range(1, 256));
}

OtherRules WhatIfCommand::rules() const {
  OtherRules out;
  if (!policy_.empty()) out.policy = by_name<PolicyKind>(policy_names, policy_);
  if (!score_.empty()) out.score = by_name<ScoreKind>(score_names, score_);
  out.agents = agents_;
  for (const std::uint32_t agent : without_) out.without.push_back({agent});
  out.bundle_limit = bundle_limit_;
  out.loss = loss_;
  if (out.none())
    throw InputError(
        "whatif: nothing is to be otherwise; legal: --policy, --score, --agents, --without, "
        "--bundle-limit, --loss");
  return out;
}

Exit WhatIfCommand::run() const {
  const OtherRules others = rules();
  const LiveRun live = read_run(run_);
  const Seeds seeds = seeds_.empty() ? Seeds{live.seed, live.seed} : seeds_of(seeds_);
  for (const std::string& line : live.left_out) fmt::print("left out: {}\n", line);
  const WorldSpec world = world_of(live, seeds.first), other = under(others, world);
  const std::vector<WorldResult> was = worlds_of(world, seeds, jobs_),
                                 is = worlds_of(other, seeds, jobs_);
  fmt::print("as it was: {}\nwhat if:   {}\n", summary(world), summary(other));
  print(was, is);
  if (was.size() == 1 && is.size() == 1) print_owners(was[0], is[0]);
  return Exit::done;
}

}  // namespace arcbid
