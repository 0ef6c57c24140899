// SPDX-License-Identifier: GPL-3.0-or-later
// Says again over DDS what the agents of a run said, so that any tool can listen.
#include <algorithm>

#include "agent/recorded_messages.hpp"
#include "core/io/domain/domain.hpp"
#include "core/io/process/command_line.hpp"
#include "idl/bus.hpp"

namespace {

using namespace arcbid;
using namespace std::chrono_literals;

constexpr auto longest_wait = 50ms;  // between two looks at what asks to stop

/// The run's agents and its coordinator as DDS sees them. Loopback only.
class Stage {
 public:
  Stage(std::uint32_t domain, const std::vector<AgentId>& fleet)
      : domain_(domain),
        agents_(network_, domain, fleet, static_cast<std::uint32_t>(fleet.size())),
        coordinator_(network_, domain, the_coordinator, static_cast<std::uint32_t>(fleet.size())) {}

  /// Throws InputError when somebody speaks there: a mission is not to be disturbed. It also is the
  /// time in which listeners are found.
  void listen(std::chrono::nanoseconds span) {
    const TimeNs end_ns = monotonic_ns() + span.count();
    while (monotonic_ns() < end_ns && !stop_requested()) {
      for (const Received& heard : agents_.wait(longest_wait))
        std::visit([this](const auto& message) { refuse(message); }, heard);
      for (const Received& heard : coordinator_.wait(0ns))
        std::visit([this](const auto& message) { refuse(message); }, heard);
    }
  }
  void say(const Mission& mission) { coordinator_.publish(mission); }
  void say(const AgentMessage& message) {
    std::visit([this](const auto& said) { agents_.publish(said); }, message);
  }
  /// What others say meanwhile is nobody's here.
  void wait(std::chrono::nanoseconds span) {
    agents_.wait(std::min<std::chrono::nanoseconds>(span, longest_wait));
    coordinator_.wait(0ns);
  }

 private:
  void refuse(const Malformed&) const {}
  template <class Message>
  [[noreturn]] void refuse(const Message&) const {
    throw InputError(fmt::format(
        "--domain {}: somebody speaks there: a mission is not to be disturbed; legal: a domain "
        "that nobody uses",
        domain_));
  }

  NetworkConfig network_;
  std::uint32_t domain_;
  Bus agents_, coordinator_;
};

std::uint64_t play(const RecordedMessages& record, Stage& stage, double rate) {
  std::uint64_t said = 0;
  std::optional<TimeNs> first_ns;
  const TimeNs start_ns = monotonic_ns();
  record.play([&](TimeNs t_ns, const AgentMessage& message) {
    if (!first_ns) first_ns = t_ns;
    const auto after_ns = [&] {
      return rate > 0 ? static_cast<TimeNs>(static_cast<double>(t_ns - *first_ns) / rate) : 0;
    };
    for (TimeNs left = 1; left > 0 && !stop_requested();) {
      left = start_ns + after_ns() - monotonic_ns();
      if (left > 0) stage.wait(std::chrono::nanoseconds(left));
    }
    if (stop_requested()) return false;
    stage.say(message);
    ++said;
    return true;
  });
  return said;
}

}  // namespace

int main(int argc, char** argv) {
  stop_on_signals();
  CLI::App app{
      "Says again over DDS what the agents of a run said, at their times: the mission, then bids, "
      "relays and statuses. On loopback only, and only where nobody else speaks. 'arcbid replay "
      "RUN "
      "--dds' starts it.",
      "arcbid-replayer"};
  app.set_version_flag("--version", ARCBID_VERSION);
  std::string run;
  std::optional<std::uint32_t> domain;
  double rate = 1, listen_s = 2;
  app.add_option("run", run, "run directory")->required()->check(CLI::ExistingDirectory);
  app.add_option("--domain", domain, "DDS domain (default: one that nobody uses)")
      ->check(CLI::Range(0, 231));
  app.add_option("--rate", rate, "times real time; 0: as fast as possible")
      ->check(CLI::Range(0.0, 1e6));
  app.add_option("--listen-s", listen_s, "how long to listen whether somebody speaks there")
      ->check(CLI::Range(0.0, 60.0));
  return run_command_line(app, argc, argv, [&] {
    const RecordedMessages record(run);
    for (const std::string& line : record.left_out()) fmt::print(stderr, "left out: {}\n", line);
    for (const std::string& line : record.of_other_builds()) fmt::print(stderr, "{}\n", line);
    std::optional<DomainLease> lease;
    const std::vector<AgentId> fleet = record.fleet();
    if (!domain) lease.emplace(static_cast<std::uint32_t>(fleet.size()));
    const std::uint32_t where = domain ? *domain : lease->domain();
    Stage stage(where, fleet);
    fmt::print("domain {}, on loopback: mission {:016x} of {} agents, {} steps on record\n", where,
               record.mission().id, fleet.size(), record.steps());
    std::fflush(stdout);
    stage.listen(std::chrono::nanoseconds(static_cast<TimeNs>(listen_s * 1e9)));
    stage.say(record.mission());
    const std::uint64_t said = play(record, stage, rate);
    stage.wait(longest_wait);  // what was said last is on its way
    fmt::print("{} messages said\n", said);
    return Exit::done;
  });
}
