// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/launcher/launch.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <memory>
#include <string>
#include <vector>

#include "core/io/domain/domain.hpp"
#include "core/io/process/process.hpp"
#include "core/io/run/run_files.hpp"
#include "sim/checker/checker.hpp"
#include "sim/launcher/child.hpp"
#include "sim/launcher/console.hpp"
#include "sim/launcher/monitor.hpp"
#include "sim/launcher/result.hpp"

namespace arcbid {
namespace {

constexpr double kFarewellS =
    15.0;  // between SIGTERM and SIGKILL; teardown of many participants is slow
constexpr double kOverdueS = 10.0;  // beyond the mission's own time limit
constexpr double kSettleS = 0.5;    // for what a dead process sent last to arrive

std::string how_it_ended(const Child& child) {
  return child.ended_by_signal() ? fmt::format("was ended by signal {}", *child.ended_by_signal())
                                 : fmt::format("ended with exit code {}", *child.exit_code());
}

/// One run, from the first process to the last.
class Run {
 public:
  explicit Run(const LaunchOptions& options)
      : options_(options),
        fleet_(fleet_ids(options.config)),
        epoch_ns_(monotonic_ns()),
        monitor_(fleet_) {
    if (!options_.config.network.domain) lease_.emplace(fleet_size(options_.config));
  }

  Exit operator()() {
    write_whole(options_.out / "config.yaml", to_yaml(options_.config));
    children_.reserve(fleet_.size() + 1);
    start("coordinator", "arcbid-coordinator", {});
    // Whatever is wrong with the input or the network, one process says it, not all.
    while (children_.front().running() && !coordinator_up_ && !stop_requested()) hear_and_reap();
    if (children_.front().running()) start_agents();
    while (anybody_runs()) {
      hear_and_reap();
      console_.progress(now_s(), monitor_);
      tell_coordinator_loss();
      consider_stopping();
    }
    tell_coordinator_loss();
    return conclude();
  }

 private:
  double now_s() const { return static_cast<double>(monotonic_ns() - epoch_ns_) * 1e-9; }
  Child& coordinator() { return children_.front(); }
  std::uint32_t id_of(std::size_t child) const { return child == 0 ? 0 : fleet_[child - 1].value; }
  bool anybody_runs() const {
    return std::any_of(children_.begin(), children_.end(),
                       [](const Child& child) { return child.running(); });
  }
  bool an_agent_runs() const {
    return std::any_of(children_.begin() + 1, children_.end(),
                       [](const Child& child) { return child.running(); });
  }

  void start(const std::string& name, const std::string& program, std::vector<std::string> words) {
    const std::uint32_t domain =
        lease_ ? lease_->domain() : options_.config.network.domain.value_or(0);
    std::vector<std::string> command{(options_.programs / program).string(),
                                     (options_.out / "config.yaml").string(),
                                     "--domain",
                                     std::to_string(domain),
                                     "--run",
                                     options_.out.string(),
                                     "--epoch-ns",
                                     std::to_string(epoch_ns_),
                                     "--parent",
                                     std::to_string(getpid()),
                                     "--json-events"};
    command.insert(command.end(), words.begin(), words.end());
    children_.emplace_back(name, command);
  }

  void start_agents() {
    for (const AgentId agent : fleet_)
      start(fmt::format("agent {}", agent.value), "arcbid-agent",
            {"--id", std::to_string(agent.value)});
    nlohmann::json processes = nlohmann::json::array();
    for (const Child& child : children_)
      processes.push_back({{"name", child.name()}, {"pid", child.pid()}});
    write_whole(options_.out / "processes.json", processes.dump(1));
  }

  void hear(std::size_t c) {
    for (const std::string& line : children_[c].read_lines()) {
      const auto event = nlohmann::json::parse(line, nullptr, false);
      if (!event.is_object()) continue;  // half a line of a process that was killed
      if (c == 0) coordinator_up_ = true;
      monitor_.heard(id_of(c), event);
    }
  }

  void hear_and_reap() {
    std::vector<pollfd> pipes;
    for (const Child& child : children_)
      if (child.output() >= 0) pipes.push_back({child.output(), POLLIN, 0});
    ::poll(pipes.data(), pipes.size(), 20);
    for (std::size_t c = 0; c < children_.size(); ++c) {
      const bool ran = children_[c].running();
      children_[c].poll();
      hear(c);  // after poll(): nothing that it said before it ended is missed
      if (!ran || children_[c].running()) continue;
      monitor_.ended(id_of(c));
      if (c == 0)
        coordinator_ended_s_ = now_s();
      else
        tell_agent_loss(children_[c]);
    }
  }

  /// Says what the end of an agent costs.
  void tell_agent_loss(const Child& agent) {
    if (stopping_since_s_ || monitor_.given_up() || agent.exit_code() == 0) return;
    console_.line(now_s(), fmt::format("{} {}: {}", agent.name(), how_it_ended(agent),
                                       an_agent_runs() ? "the others take over its arcs"
                                                       : "no agent is left"));
  }

  /// Says what the end of the coordinator costs, once it is clear who has the mission.
  void tell_coordinator_loss() {
    const bool settled = !anybody_runs() || now_s() - coordinator_ended_s_ > kSettleS;
    if (coordinator().running() || coordinator_loss_told_ || !settled) return;
    coordinator_loss_told_ = true;
    if (monitor_.complete() || stopping_since_s_) return;
    if (coordinator().exit_code() == static_cast<int>(Exit::bad_input)) return stop("");
    if (monitor_.given_up())
      return stop(
          fmt::format("given up: not done after {} s (timeout_s)", options_.config.timeout_s));
    const std::string how = "coordinator " + how_it_ended(coordinator());
    std::string without;
    std::size_t with = 0;
    for (const auto& [id, agent] : monitor_.agents()) {
      if (agent.has_mission)
        ++with;
      else
        without += fmt::format(" {}", id);
    }
    if (with == 0)
      return stop(how + " before any agent had the mission: nothing was begun, nothing is lost");
    console_.line(now_s(),
                  fmt::format("{}: the mission was published and is not lost, {} of {} agents "
                              "have it and go on",
                              how, with, fleet_.size()));
    if (!without.empty())
      console_.line(now_s(), fmt::format("agents without the mission take no part:{}", without));
  }

  void consider_stopping() {
    if (stop_requested()) {
      interrupted_ = true;
      stop("stopped by a signal");
    } else if (now_s() > options_.config.timeout_s + kOverdueS) {
      stop("given up: not done in time, and the coordinator did not say so");
    } else if (!an_agent_runs() && !monitor_.outcome() && !monitor_.given_up()) {
      stop("no agent is left: the mission cannot be done");
    } else if (coordinator_loss_told_ && (monitor_.complete() || monitor_.outcome())) {
      stop("");  // without a coordinator nobody else tells the agents that all is done
    }
    if (stopping_since_s_ && now_s() - *stopping_since_s_ > kFarewellS)
      for (const Child& child : children_) child.signal(SIGKILL);
  }

  void stop(const std::string& why) {
    if (stopping_since_s_) return;
    stopping_since_s_ = now_s();
    if (!why.empty()) console_.line(now_s(), why);
    for (const Child& child : children_) child.signal(SIGTERM);
  }

  /// Routes of agents that were not part of the final agreement are no longer valid.
  void set_void_routes_aside(const Monitor::Outcome& outcome) {
    for (const auto& [id, agent] : monitor_.agents()) {
      const auto file = route_file(options_.out, {id});
      if (outcome.members.contains(id) || !std::filesystem::exists(file)) continue;
      std::filesystem::create_directories(options_.out / "void_routes");
      std::filesystem::rename(file, options_.out / "void_routes" / file.filename());
    }
  }

  Exit conclude() {
    if (coordinator().exit_code() == static_cast<int>(Exit::bad_input)) return Exit::bad_input;
    const auto outcome = monitor_.outcome();
    if (outcome) set_void_routes_aside(*outcome);
    std::vector<ProcessEnd> ends;
    for (const Child& child : children_)
      ends.push_back({child.name(), child.pid(), child.exit_code(), child.ended_by_signal()});
    const CheckReport report = check_run(options_.out);
    const auto result = result_json(report, monitor_, ends, now_s());
    write_whole(options_.out / "result.json", result.dump(2) + "\n");
    console_.line(now_s(), "every process has ended; result checked");
    if (outcome)
      for (const std::string& problem : report.problems) fmt::print("problem: {}\n", problem);
    if (outcome)
      fmt::print("{}", result_table(result));
    else
      console_.line(now_s(), "no result: the agents did not agree");
    fmt::print("{:<20}{}\n", "run directory", options_.out.string());
    return outcome && report.ok() && !interrupted_ ? Exit::done : Exit::check_failed;
  }

  const LaunchOptions& options_;
  const std::vector<AgentId> fleet_;
  const TimeNs epoch_ns_;
  std::optional<DomainLease> lease_;
  Monitor monitor_;
  Console console_;
  std::vector<Child> children_;  // the coordinator, then the agents as in fleet_
  bool coordinator_up_ = false, coordinator_loss_told_ = false, interrupted_ = false;
  double coordinator_ended_s_ = 0;
  std::optional<double> stopping_since_s_;
};

}  // namespace

Exit launch(const LaunchOptions& options) {
  std::error_code none;
  if (std::filesystem::exists(options.out, none) && !std::filesystem::is_empty(options.out, none))
    throw InputError(
        fmt::format("{}: is not empty; name a new directory with --out", options.out.string()));
  const Exit exit = Run(options)();
  // Refused input makes no run: the same command works again once it is mended.
  if (exit == Exit::bad_input) std::filesystem::remove_all(options.out, none);
  return exit;
}

}  // namespace arcbid
