// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/commands/replay_command.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <future>
#include <thread>

#include "core/io/build/build.hpp"
#include "sim/commands/replay_terminal.hpp"
#include "sim/commands/tell.hpp"
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
  if (life.damage())
    return fmt::format("damaged, {} steps behind that are not replayed: {}",
                       life.marks().size() - *life.gap(), *life.damage());
  return life.ended_by().empty() ? "killed: its log ends without a word"
                                 : fmt::format("ended by {}", life.ended_by());
}

}  // namespace

ReplayCommand::ReplayCommand(CLI::App& app)
    : command_(app.add_subcommand("replay", "play a run's logs again")) {
  command_->add_option("run", run_, "run directory")->required()->check(CLI::ExistingDirectory);
  CLI::Option* verify =
      command_->add_flag("--verify", verify_,
                         "feed every agent's state machine its logged inputs and demand the same "
                         "decisions, bit for bit");
  CLI::Option* dds = command_->add_flag(
      "--dds", dds_, "say it all again over DDS, on loopback, for any tool that listens");
  dds->excludes(verify);
  command_->add_option("--domain", domain_, "DDS domain for --dds (default: one that nobody uses)")
      ->needs(dds)
      ->check(CLI::Range(0, 231));
  CLI::Option* rate =
      command_->add_option("--rate", rate_, "times real time; 0: as fast as possible (default: 1)")
          ->check(CLI::Range(0.0, 1e6));
  rate->excludes(verify);
  // The whole run is verified, and the whole run is said again: nothing is to be chosen.
  for (CLI::Option* option : add_playing()) option->excludes(verify)->excludes(dds);
}

std::vector<CLI::Option*> ReplayCommand::add_playing() {
  return {
      command_->add_option("--from", from_, "seconds since launch, round:N, or event:NAME"),
      command_->add_option("--until", until_, "likewise: where it ends"),
      command_->add_option("--agent", agent_, "show what this agent did only"),
      command_->add_option("--arc", arc_, "show what is about this arc only"),
      command_->add_option("--topic", topic_, "show steps of this kind only")
          ->check(CLI::IsMember(std::vector<std::string>(topic_names.begin(), topic_names.end()))),
      command_->add_flag("--loop", loop_, "begin again at the end (on a terminal)"),
      command_
          ->add_option("--step", step_,
                       "how many shown moments a key moves; without a terminal: how many are shown")
          ->check(CLI::Range(1, 1'000'000)),
  };
}

Exit ReplayCommand::run(const std::filesystem::path& programs) const {
  if (verify_) return verify_all();
  return dds_ ? publish(programs) : play();
}

Exit ReplayCommand::play() const {
  const RunArchive run = open_run(run_);
  for (const std::string& problem : run.unreadable) fmt::print("left out: {}\n", problem);
  tell_unverifiable(run);
  MomentFilter filter;
  const std::vector<Uav>& fleet = run.mission->fleet;
  if (agent_ && std::none_of(fleet.begin(), fleet.end(),
                             [this](const Uav& uav) { return uav.id == AgentId{*agent_}; }))
    throw InputError(fmt::format("--agent {}: is not of the fleet of {}", *agent_, run_));
  if (arc_ && *arc_ >= run.mission->arcs.size())
    throw InputError(
        fmt::format("--arc {}: {} has arcs 0 to {}", *arc_, run_, run.mission->arcs.size() - 1));
  if (agent_) filter.agent = AgentId{*agent_};
  if (arc_) filter.arc = ArcId{*arc_};
  const auto topic = std::find(topic_names.begin(), topic_names.end(), topic_);
  if (!topic_.empty()) filter.topic = static_cast<Topic>(topic - topic_names.begin());
  const Playback playback(run);
  Player player(run, playback, filter);
  if (!until_.empty()) player.set_until(until_);
  if (!from_.empty()) player.seek(from_);
  player.set_begin();
  player.set_rate(rate_.value_or(1));
  player.set_loop(loop_);
  if (isatty(STDOUT_FILENO) != 0)
    play_on_terminal(run, playback, player, std::max(step_, 1));
  else if (loop_)
    throw InputError("--loop: has no end without a terminal");
  else
    play_plainly(run, playback, player, step_);
  return Exit::done;
}

/// It is another program: this one speaks no DDS.
Exit ReplayCommand::publish(const std::filesystem::path& programs) const {
  const std::string program = programs / "arcbid-replayer";
  std::vector<std::string> line{program, run_};
  if (domain_) line.insert(line.end(), {"--domain", std::to_string(*domain_)});
  if (rate_) line.insert(line.end(), {"--rate", fmt::to_string(*rate_)});
  std::vector<char*> arguments;
  for (std::string& argument : line) arguments.push_back(argument.data());
  arguments.push_back(nullptr);
  execv(program.c_str(), arguments.data());
  throw RunError(fmt::format("{}: cannot be started", program));
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
