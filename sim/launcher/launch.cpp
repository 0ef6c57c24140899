// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/launcher/launch.hpp"

#include <fmt/format.h>
#include <poll.h>

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

constexpr double kFarewellS = 15.0;  // between SIGTERM and SIGKILL; teardown of many participants is slow
constexpr double kOverdueS = 10.0;   // beyond the mission's own time limit

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
    start_all();
    while (std::any_of(children_.begin(), children_.end(), [](const Child& c) { return c.running(); })) {
      hear_children();
      reap();
      console_.progress(now_s(), monitor_);
      consider_stopping();
    }
    hear_children();
    return conclude();
  }

 private:
  double now_s() const { return static_cast<double>(monotonic_ns() - epoch_ns_) * 1e-9; }

  void start(const std::string& name, const std::string& program, std::vector<std::string> words) {
    std::vector<std::string> command{(options_.programs / program).string(),
                                     (options_.out / "config.yaml").string()};
    command.insert(command.end(), words.begin(), words.end());
    const std::uint32_t domain =
        lease_ ? lease_->domain() : options_.config.network.domain.value_or(0);
    for (const std::string& word :
         {std::string("--domain"), std::to_string(domain), std::string("--run"),
          options_.out.string(), std::string("--epoch-ns"), std::to_string(epoch_ns_),
          std::string("--json-events"), std::string("--with-parent")})
      command.push_back(word);
    children_.emplace_back(name, command);
  }

  void start_all() {
    write_whole(options_.out / "config.yaml", to_yaml(options_.config));
    start("coordinator", "arcbid-coordinator", {});
    for (const AgentId agent : fleet_)
      start(fmt::format("agent {}", agent.value), "arcbid-agent",
            {"--id", std::to_string(agent.value)});
    nlohmann::json processes = nlohmann::json::array();
    for (const Child& child : children_)
      processes.push_back({{"name", child.name()}, {"pid", child.pid()}});
    write_whole(options_.out / "processes.json", processes.dump(1));
  }

  std::uint32_t id_of(std::size_t child) const { return child == 0 ? 0 : fleet_[child - 1].value; }

  void hear_children() {
    std::vector<pollfd> pipes;
    for (const Child& child : children_)
      if (child.output() >= 0) pipes.push_back({child.output(), POLLIN, 0});
    ::poll(pipes.data(), pipes.size(), 20);
    for (std::size_t c = 0; c < children_.size(); ++c)
      for (const std::string& line : children_[c].read_lines()) {
        const auto event = nlohmann::json::parse(line, nullptr, false);
        // A killed process may leave half a line.
        if (event.is_object()) monitor_.heard(id_of(c), event);
      }
  }

  void reap() {
    for (std::size_t c = 0; c < children_.size(); ++c) {
      if (!children_[c].running()) continue;
      children_[c].poll();
      if (children_[c].running()) continue;
      monitor_.ended(id_of(c));
      if (children_[c].exit_code() != 0) tell_loss(c);
    }
  }

  /// Says what the end of a process costs.
  void tell_loss(std::size_t c) {
    const Child& child = children_[c];
    const std::string how = child.ended_by_signal()
                                ? fmt::format("was ended by signal {}", *child.ended_by_signal())
                                : fmt::format("ended with exit code {}", *child.exit_code());
    std::string cost;
    if (c != 0)
      cost = "the others take over its arcs";
    else if (child.exit_code() == static_cast<int>(Exit::bad_input))
      return stop("the coordinator refused its input");
    else if (monitor_.arcs())
      cost = "the mission was published and is not lost: the agents go on; only its event log ends here";
    else
      return stop(fmt::format("coordinator {} before it published the mission: nothing was begun, "
                              "nothing is lost", how));
    console_.line(now_s(), fmt::format("{} {}: {}", child.name(), how, cost));
  }

  void consider_stopping() {
    const bool coordinator_gone = !children_.front().running();
    if (stop_requested()) stop("stopped by a signal");
    else if (now_s() > options_.config.timeout_s + kOverdueS) stop("timeout");
    // Without a coordinator nobody tells the agents that all is done.
    else if (coordinator_gone && (monitor_.complete() || monitor_.outcome())) stop("");
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
    if (children_.front().exit_code() == static_cast<int>(Exit::bad_input)) return Exit::bad_input;
    const auto outcome = monitor_.outcome();
    if (outcome) set_void_routes_aside(*outcome);
    std::vector<ProcessEnd> ends;
    for (const Child& child : children_)
      ends.push_back({child.name(), child.pid(), child.exit_code(), child.ended_by_signal()});
    const CheckReport report = check_run(options_.out);
    const auto result = result_json(report, monitor_, ends, now_s());
    write_whole(options_.out / "result.json", result.dump(2) + "\n");
    console_.line(now_s(), "every process has ended; result checked");
    for (const std::string& problem : report.problems) fmt::print("problem: {}\n", problem);
    fmt::print("{}{:<20}{}\n", result_table(result), "run directory", options_.out.string());
    return outcome && report.ok() ? Exit::done : Exit::check_failed;
  }

  const LaunchOptions& options_;
  const std::vector<AgentId> fleet_;
  const TimeNs epoch_ns_;
  std::optional<DomainLease> lease_;
  Monitor monitor_;
  Console console_;
  std::vector<Child> children_;
  std::optional<double> stopping_since_s_;
};

}  // namespace

Exit launch(const LaunchOptions& options) {
  if (std::filesystem::exists(options.out / "arcs.json"))
    throw InputError(fmt::format("{}: holds a run already; name another directory with --out",
                                 options.out.string()));
  return Run(options)();
}

}  // namespace arcbid
