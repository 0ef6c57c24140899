// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/commands/replay_command.hpp"

#include <fmt/format.h>

#include <future>
#include <thread>

#include "core/io/build/build.hpp"
#include "sim/replay/verify.hpp"

namespace arcbid {
namespace {

std::vector<LifeVerdict> verdicts(const RunArchive& run) {
  std::vector<LifeVerdict> out;
  const std::size_t at_once = std::max(1u, std::thread::hardware_concurrency());
  for (std::size_t from = 0; from < run.lives.size(); from += at_once) {
    std::vector<std::future<LifeVerdict>> some;
    for (std::size_t l = from; l < std::min(run.lives.size(), from + at_once); ++l)
      some.push_back(std::async(std::launch::async, [&run, l] { return verify(run.lives[l]); }));
    for (auto& one : some) out.push_back(one.get());
  }
  return out;
}

std::string how_it_ended(const LifeLog& life) {
  if (life.damage()) return fmt::format("damaged: {}", *life.damage());
  return life.ended_by().empty() ? "killed: its log ends without a word"
                                 : fmt::format("ended by {}", life.ended_by());
}

}  // namespace

ReplayCommand::ReplayCommand(CLI::App& app)
    : command_(app.add_subcommand("replay", "play a run's logs again")) {
  command_->add_option("run", run_, "run directory")->required()->check(CLI::ExistingDirectory);
  command_->add_flag("--verify", verify_,
                     "feed every agent's state machine its logged inputs and demand the same "
                     "decisions, bit for bit");
}

Exit ReplayCommand::run() const {
  return verify_all();
}

/// The first to diverge, in time, is the one that is named last, where it is read.
Exit ReplayCommand::verify_all() const {
  const RunArchive run = open_run(run_);
  for (const std::string& problem : run.unreadable) fmt::print("left out: {}\n", problem);
  const std::vector<LifeVerdict> found = verdicts(run);
  const Divergence* first = nullptr;
  std::size_t steps = 0, routes = 0;
  for (std::size_t l = 0; l < found.size(); ++l) {
    const LifeLog& life = run.lives[l];
    const auto& divergence = found[l].divergence;
    fmt::print("agent {:>3}  life {:<20} {:>7} steps, {} routes  {}; {}\n", life.agent().value,
               life.incarnation(), found[l].steps, found[l].routes,
               divergence ? "diverges" : "the same, bit for bit", how_it_ended(life));
    steps += found[l].steps;
    routes += found[l].routes;
    if (divergence && (!first || divergence->t_ns < first->t_ns)) first = &*divergence;
  }
  if (!first) {
    fmt::print("verified: {} lives, {} steps, {} routes\n", found.size(), steps, routes);
    return Exit::done;
  }
  fmt::print("first divergence: {}\n", describe(*first));
  const std::string ours = fmt::format("{} {}", build_version(), build_commit());
  for (const LifeLog& life : run.lives)
    if (life.agent() == first->agent && life.build() != ours) {
      fmt::print("recorded by arcbid {}, this is {}: another build may decide otherwise\n",
                 life.build(), ours);
      break;
    }
  return Exit::check_failed;
}

}  // namespace arcbid
