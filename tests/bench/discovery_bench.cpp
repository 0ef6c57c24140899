// SPDX-License-Identifier: GPL-3.0-or-later
// What it costs N agents to find each other over DDS, each in a process of its own but for the last
// way: seconds until every process has matched all others, CPU of all of them until then, memory
// and datagrams. The datagrams are the whole machine's: nothing else should be talking.
//
//   discovery_bench [N...]    (16 64) a table in Markdown on standard output
#include <fmt/format.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <functional>
#include <iterator>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "core/base/error.hpp"
#include "core/io/domain/domain.hpp"
#include "core/io/process/process.hpp"
#include "tests/bench/discovery_peer.hpp"

namespace {

using namespace arcbid;
using namespace arcbid::bench;

constexpr unsigned kLimit_s = 60;
constexpr double kNotMet = -1;

const std::vector<Way> ways{
    {.name = "as arcbid does it: 4 writers, 5 readers"},
    {.name = "one topic for several kinds: 2 writers, 2 readers", .two_topics = true},
    {.name = "4 + 5, announced to the ports below one's own", .meeting = Meeting::those_below},
    {.name = "2 + 2, announced to the ports below",
     .meeting = Meeting::those_below,
     .two_topics = true},
    {.name = "2 + 2, endpoints static, announced to the ports below",
     .meeting = Meeting::those_below,
     .two_topics = true,
     .static_endpoints = true},
    {.name = "4 + 5, a discovery server", .meeting = Meeting::server},
    {.name = "as arcbid does it, eight agents a process", .agents_per_process = 8},
};

double seconds_since(TimeNs start_ns) {
  return static_cast<double>(monotonic_ns() - start_ns) * 1e-9;
}

/// Since boot, of this network namespace; 0 where the kernel does not say.
std::uint64_t udp_datagrams_sent() {
  std::ifstream file("/proc/net/snmp");
  std::vector<std::string> names;
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with("Udp:")) continue;
    std::istringstream words(line);
    const std::vector<std::string> row{std::istream_iterator<std::string>(words), {}};
    if (names.empty()) {
      names = row;
      continue;
    }
    for (std::size_t k = 0; k < std::min(names.size(), row.size()); ++k)
      if (names[k] == "OutDatagrams") return std::stoull(row[k]);
  }
  return 0;
}

/// The processes of one measurement. They stay, so that nobody's end is part of it, until this
/// ends them, each by its id.
class Processes {
 public:
  Processes() {
    if (pipe(pipe_.data()) != 0) throw RunError("cannot open a pipe: too many files are open");
  }

  ~Processes() {
    end();
    for (const int fd : pipe_) close(fd);
  }

  /// `body` returns what the process has to say; then it waits to be ended.
  void start(const std::function<double()>& body) {
    const pid_t parent = getpid(), child = fork();
    if (child < 0) throw RunError("cannot fork: too many processes");
    if (child > 0) {
      ids_.push_back(child);
      return;
    }
    alarm(2 * kLimit_s);
    end_with_parent(parent);
    dup2(STDERR_FILENO, STDOUT_FILENO);  // Fast DDS's log must not get into the table
    _exit(run_program([&] {
      const double word = body();
      if (write(pipe_[1], &word, sizeof word) != sizeof word) return Exit::check_failed;
      for (;;) pause();
    }));
  }

  /// What the next of them says; none when `limit_ns` of the monotonic clock comes first.
  std::optional<double> next_word(TimeNs limit_ns) {
    const TimeNs left_ms = std::max<TimeNs>(limit_ns - monotonic_ns(), 0) / 1'000'000;
    pollfd readable{pipe_[0], POLLIN, 0};
    double word = 0;
    if (poll(&readable, 1, static_cast<int>(left_ms)) == 1 &&
        read(pipe_[0], &word, sizeof word) == sizeof word)
      return word;
    return std::nullopt;
  }

  void end() {
    for (const pid_t id : ids_) kill(id, SIGKILL);
    for (const pid_t id : ids_) {
      rusage used{};
      wait4(id, nullptr, 0, &used);
      for (const timeval& time : {used.ru_utime, used.ru_stime})
        cpu_s_ += static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
      largest_mb_ = std::max(largest_mb_, static_cast<double>(used.ru_maxrss) / 1024);
    }
    ids_.clear();
  }

  /// Of all of them; known after end().
  double cpu_s() const { return cpu_s_; }
  double largest_mb() const { return largest_mb_; }

 private:
  std::array<int, 2> pipe_{};
  std::vector<pid_t> ids_;
  double cpu_s_ = 0, largest_mb_ = 0;
};

void start_all(Processes& processes, const Way& way, const Fleet& fleet, TimeNs start_ns,
               TimeNs limit_ns) {
  for (std::uint32_t p = 0; p < fleet.processes(); ++p)
    processes.start([&, p] {
      const bool met = meet_all(way, fleet, p, limit_ns);
      return met ? seconds_since(start_ns) : kNotMet;
    });
}

/// Returned once it is there: its start is not part of the measurement.
void start_server(Processes& processes, const Fleet& fleet) {
  processes.start([&] {
    start_discovery_server(fleet);
    return 0.0;
  });
  if (!processes.next_word(monotonic_ns() + 10'000'000'000))
    throw RunError("the discovery server does not start within 10 s");
}

/// Prints a row of the table.
void measure(const Way& way, std::uint32_t agents) {
  const DomainLease lease(agents);
  const Fleet fleet{lease.domain(), agents, way.agents_per_process};
  Processes processes;
  if (way.meeting == Meeting::server) start_server(processes, fleet);
  const std::uint64_t sent_before = udp_datagrams_sent();
  const TimeNs start_ns = monotonic_ns(), limit_ns = start_ns + kLimit_s * 1'000'000'000ll;
  start_all(processes, way, fleet, start_ns, limit_ns);
  double slowest_s = 0;
  std::uint32_t met = 0;
  for (std::uint32_t p = 0; p < fleet.processes(); ++p) {
    const auto word = processes.next_word(limit_ns + 5'000'000'000);
    if (!word) break;  // some process died
    if (*word == kNotMet) continue;
    slowest_s = std::max(slowest_s, *word);
    ++met;
  }
  const std::uint64_t sent = udp_datagrams_sent() - sent_before;
  processes.end();
  const std::uint32_t incomplete = fleet.processes() - met;
  const std::string seconds = incomplete == 0
                                  ? fmt::format("{:.1f}", slowest_s)
                                  : fmt::format("not in {} ({} incomplete)", kLimit_s, incomplete);
  fmt::print("| {} | {} | {} | {} | {:.1f} | {:.1f} | {} |\n", way.name, agents, fleet.processes(),
             seconds, processes.cpu_s(), processes.largest_mb(), sent);
  std::fflush(stdout);
}

std::uint32_t fleet_size(const std::string& text) {
  std::uint32_t agents = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), agents);
  if (error != std::errc() || end != text.data() + text.size() || agents < 2 ||
      agents > kMaxFleetOfDomain)
    throw InputError(fmt::format("discovery_bench: N: '{}' is not an integer in [2, {}]", text,
                                 kMaxFleetOfDomain));
  return agents;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program([&] {
    std::vector<std::uint32_t> sizes;
    for (int k = 1; k < argc; ++k) sizes.push_back(fleet_size(argv[k]));
    if (sizes.empty()) sizes = {16, 64};
    fmt::print("| way | N | processes | all matched, s | CPU, s | largest, MB | datagrams |\n");
    fmt::print("|---|---:|---:|---:|---:|---:|---:|\n");
    std::fflush(stdout);
    for (const std::uint32_t agents : sizes)
      for (const Way& way : ways) measure(way, agents);
    return Exit::done;
  });
}
