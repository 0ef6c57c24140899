// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/launcher/launch.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "core/io/domain/domain.hpp"
#include "core/io/faults/fault_files.hpp"
#include "core/io/process/process.hpp"
#include "core/io/run/run_files.hpp"
#include "core/io/run/run_lock.hpp"
#include "sim/checker/checker.hpp"
#include "sim/launcher/child.hpp"
#include "sim/launcher/console.hpp"
#include "sim/launcher/fault_script.hpp"
#include "sim/launcher/monitor.hpp"
#include "sim/launcher/result.hpp"
#include "sim/launcher/shared_processes.hpp"

namespace arcbid {
namespace {

constexpr double kFarewellS =
    15.0;  // between SIGTERM and SIGKILL; teardown of many participants is slow
constexpr double kOverdueS = 10.0;   // beyond the mission's own time limit
constexpr double kPatienceS = 10.0;  // between lines that say what is waited for
constexpr double kSettleS = 0.5;     // for what a dead process sent last to arrive

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
        monitor_(fleet_),
        script_(options_.faults.value_or(FaultSchedule{})),
        console_(options_.fault_tier) {
    if (!options_.config.network.domain) lease_.emplace(fleet_size(options_.config));
  }

  Exit operator()() {
    write_whole(options_.out / "config.yaml", to_yaml(options_.config));
    if (options_.faults) write_whole(faults_file(), to_yaml(*options_.faults));
    start_coordinator();
    // Whatever is wrong with the input or the network, one process says it, not all.
    while (coordinator().running() && !coordinator_up_ && !stop_requested()) hear_and_reap();
    if (coordinator().running()) start_agents();
    while (anybody_runs() || somebody_returns()) {
      hear_and_reap();
      act_faults();
      console_.progress(now_s(), monitor_);
      tell_coordinator_loss();
      watch_planning();
      consider_stopping();
    }
    tell_coordinator_loss();
    return conclude();
  }

 private:
  double now_s() const { return static_cast<double>(monotonic_ns() - epoch_ns_) * 1e-9; }
  std::filesystem::path faults_file() const { return options_.out / "faults.yaml"; }
  bool is_of(std::size_t c, AgentId agent) const {
    return std::find(ids_[c].begin(), ids_[c].end(), agent) != ids_[c].end();
  }
  bool is_coordinator(std::size_t c) const { return is_of(c, {0}); }
  /// The newest process of an agent, or of the coordinator (0); twins aside.
  Child* process_of(AgentId agent) {
    for (std::size_t c = children_.size(); c-- > 0;)
      if (is_of(c, agent) && !twins_.contains(c)) return &children_[c];
    return nullptr;
  }
  Child& coordinator() { return *process_of({0}); }
  bool somebody_returns() const {
    return !stopping_since_s_ && std::any_of(fleet_.begin(), fleet_.end(), [this](AgentId agent) {
      return script_.returns(agent);
    });
  }
  bool anybody_runs() const {
    return std::any_of(children_.begin(), children_.end(),
                       [](const Child& child) { return child.running(); });
  }
  bool an_agent_runs() const {
    for (std::size_t c = 0; c < children_.size(); ++c)
      if (!is_coordinator(c) && children_[c].running()) return true;
    return somebody_returns();
  }

  void start(const std::vector<AgentId>& ids, const std::string& name, const std::string& program,
             std::vector<std::string> words) {
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
    ids_.push_back(ids);
  }

  TimeNs faults_over_ns() const {
    const AuctionSettings& auction = options_.config.auction;
    return script_.over_ns(auction.lease_ns, auction.tick_ns);
  }

  void start_coordinator() {
    start({AgentId{0}}, "coordinator", "arcbid-coordinator",
          {"--not-before-ns", std::to_string(faults_over_ns())});
  }

  /// The process of one agent, or of several that share it.
  void start_agents_of(const std::vector<AgentId>& ids, const std::string& suffix = "") {
    std::vector<std::uint32_t> numbers;
    for (const AgentId id : ids) numbers.push_back(id.value);
    const std::string list = fmt::format("{}", fmt::join(numbers, ","));
    std::vector<std::string> words{"--id", list};
    if (options_.faults)
      words.insert(words.end(), {"--faults", faults_file().string(), "--fault-tier",
                                 std::string(name_of(options_.fault_tier))});
    start(ids, fmt::format("agent{} {}{}", ids.size() > 1 ? "s" : "", list, suffix), "arcbid-agent",
          words);
  }

  void start_agents() {
    const std::size_t most = options_.config.fleet.agents_per_process;
    std::vector<AgentId> together;
    for (const AgentId agent : fleet_) {
      if (!script_.comes_late(agent)) together.push_back(agent);
      if (together.empty() || (together.size() < most && agent != fleet_.back())) continue;
      start_agents_of(together);
      together.clear();
    }
    write_processes();
  }

  void write_processes() const {
    nlohmann::json processes = nlohmann::json::array();
    for (const Child& child : children_)
      processes.push_back({{"name", child.name()}, {"pid", child.pid()}});
    write_whole(options_.out / "processes.json", processes.dump(1));
  }

  /// What the fault schedule says is to be done to processes by now.
  void act_faults() {
    ProcessFault fault;
    while (!stopping_since_s_ && script_.next(monotonic_ns() - epoch_ns_, fault)) {
      console_.line(now_s(), "fault: " + in_words(fault));
      acted_.push_back({{"time_s", now_s()},
                        {"agent", fault.agent.value},
                        {"action", name_of(fault.action)},
                        {"fault", in_words(fault)}});
      act(fault);
    }
  }

  void act(const ProcessFault& fault) {
    switch (fault.action) {
      case ProcessAction::kill:
        return signal(process_of(fault.agent), SIGKILL);
      case ProcessAction::pause:
        return signal(process_of(fault.agent), SIGSTOP);
      case ProcessAction::resume:
        return signal(process_of(fault.agent), SIGCONT);
      case ProcessAction::start:
        if (fault.agent == AgentId{0}) return start_coordinator();
        monitor_.starts(fault.agent.value);
        start_agents_of({fault.agent});
        return write_processes();
      case ProcessAction::start_twin:
        twins_.insert(children_.size());
        return start_agents_of({fault.agent}, ", second");
      case ProcessAction::kill_twin:
        for (const std::size_t twin : twins_)
          if (is_of(twin, fault.agent)) signal(&children_[twin], SIGKILL);
        return;
    }
  }

  static void signal(const Child* child, int number) {
    if (child != nullptr && child->running()) child->signal(number);
  }

  void hear(std::size_t c) {
    for (const std::string& line : children_[c].read_lines()) {
      const auto event = nlohmann::json::parse(line, nullptr, false);
      if (!event.is_object()) continue;  // half a line of a process that was killed
      if (is_coordinator(c)) coordinator_up_ = true;
      if (twins_.contains(c)) continue;  // what it says of itself is not said of the agent
      monitor_.heard(event.value("of", ids_[c].front().value), event);
      if (event.value("event", "") == "released") tell_release(event);
    }
  }

  /// Says once whose tasks are free again.
  void tell_release(const nlohmann::json& event) {
    const std::uint32_t agent = event.at("agent");
    const std::size_t tasks = event.at("tasks").size();
    if (!released_.insert(agent).second) return;
    console_.line(now_s(),
                  fmt::format("agent {} counts as dead: its {} tasks are free", agent, tasks));
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
      if (twins_.contains(c)) {
        tell_twin_end(children_[c]);
        continue;
      }
      for (const AgentId id : ids_[c]) monitor_.ended(id.value);
      if (is_coordinator(c))
        coordinator_ended_s_ = now_s();
      else
        tell_agent_loss(children_[c], ids_[c]);
    }
  }

  /// Says what the end of an agent costs.
  void tell_agent_loss(const Child& process, const std::vector<AgentId>& ids) {
    if (stopping_since_s_ || monitor_.given_up() || process.exit_code() == 0) return;
    for (const AgentId id : ids) released_.erase(id.value);  // its next death is another one
    const bool returns = script_.returns(ids.front());
    console_.line(now_s(), fmt::format("{} {}: {}", process.name(), how_it_ended(process),
                                       returns           ? "it will be back"
                                       : an_agent_runs() ? "the others take over its arcs"
                                                         : "no agent is left"));
  }

  void tell_twin_end(const Child& twin) {
    if (!stopping_since_s_)
      console_.line(now_s(), fmt::format("{}, {}", twin.name(), how_it_ended(twin)));
  }

  /// Says what the end of the coordinator costs, once it is clear who has the mission.
  void tell_coordinator_loss() {
    const bool settled = !anybody_runs() || now_s() - coordinator_ended_s_ > kSettleS;
    if (coordinator().running() || coordinator_loss_told_ || !settled) return;
    if (!stopping_since_s_ && script_.returns({0})) return;
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

  /// Large structures take minutes to plan.
  void watch_planning() {
    if (!published_s_ && monitor_.arcs()) published_s_ = now_s();
    if (published_s_ || stopping_since_s_ || !coordinator().running()) return;
    if (now_s() < told_of_planning_s_ + kPatienceS) return;
    told_of_planning_s_ = now_s();
    console_.line(now_s(), "the coordinator is still planning");
  }

  void consider_stopping() {
    if (stop_requested()) {
      interrupted_ = true;
      stop("stopped by a signal");
    } else if (published_s_ && now_s() > *published_s_ + options_.config.timeout_s + kOverdueS) {
      stop("given up: not done in time, and the coordinator did not say so");
    } else if (!an_agent_runs() && !monitor_.outcome() && !monitor_.given_up()) {
      stop("no agent is left: the mission cannot be done");
    } else if (coordinator_loss_told_ && (monitor_.complete() || monitor_.outcome()) &&
               monotonic_ns() - epoch_ns_ >= faults_over_ns()) {
      stop("");  // without a coordinator nobody else tells the agents that all is done
    }
    if (stopping_since_s_ && now_s() - *stopping_since_s_ > kFarewellS)
      for (const Child& child : children_) child.signal(SIGKILL);
  }

  void stop(const std::string& why) {
    if (stopping_since_s_) return;
    stopping_since_s_ = now_s();
    if (!why.empty()) console_.line(now_s(), why);
    for (const Child& child : children_) {
      child.signal(SIGTERM);
      child.signal(SIGCONT);  // one that is paused could not obey
    }
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
    auto result = result_json(report, monitor_, ends, now_s());
    if (options_.faults) {
      result["fault_tier"] = name_of(options_.fault_tier);
      result["faults"] = acted_;
    }
    write_whole(options_.out / "result.json", result.dump(2) + "\n");
    console_.line(now_s(), "every process has ended; result checked");
    if (outcome)
      for (const std::string& problem : report.problems) fmt::print("problem: {}\n", problem);
    if (outcome)
      for (const LeftUndone& left : report.left) fmt::print("left undone: {}\n", left.text);
    if (outcome)
      fmt::print("{}", result_table(result));
    else
      console_.line(now_s(), "no result: the agents did not agree");
    fmt::print("{:<20}{}\n", "run directory", options_.out.string());
    return outcome && report.all_done() && !interrupted_ ? Exit::done : Exit::check_failed;
  }

  const LaunchOptions& options_;
  const std::vector<AgentId> fleet_;
  const TimeNs epoch_ns_;
  std::optional<DomainLease> lease_;
  Monitor monitor_;
  FaultScript script_;
  Console console_;
  std::vector<Child> children_;            // in the order in which they were started
  std::vector<std::vector<AgentId>> ids_;  // whose process each is; 0: the coordinator's
  std::set<std::size_t> twins_;            // those that are second with their id
  std::set<std::uint32_t> released_;
  nlohmann::json acted_ = nlohmann::json::array();  // faults done to processes
  bool coordinator_up_ = false, coordinator_loss_told_ = false, interrupted_ = false;
  double coordinator_ended_s_ = 0;
  double told_of_planning_s_ = 0;
  std::optional<double> published_s_, stopping_since_s_;
};

}  // namespace

Exit launch(const LaunchOptions& options) {
  require_own_processes(options);
  std::error_code none;
  if (std::filesystem::exists(options.out, none) && !std::filesystem::is_empty(options.out, none))
    throw InputError(
        fmt::format("{}: is not empty; name a new directory with --out", options.out.string()));
  const bool is_new = !std::filesystem::exists(options.out, none);
  // Refused input makes no run: the same command works again once it is mended.
  try {
    const RunLock running(options.out);
    const Exit exit = Run(options)();
    if (exit == Exit::bad_input) std::filesystem::remove_all(options.out, none);
    return exit;
  } catch (const InputError&) {
    if (is_new) std::filesystem::remove(options.out, none);  // if nothing is in it
    throw;
  }
}

}  // namespace arcbid
