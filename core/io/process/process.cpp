// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/process/process.hpp"

#include <fmt/format.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <utility>

namespace arcbid {
namespace {

volatile std::sig_atomic_t stop_signal = 0;
extern "C" void note_stop(int signal) {
  stop_signal = signal;
}

double clock_s(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

TimeNs monotonic_ns() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

double thread_cpu_s() {
  return clock_s(CLOCK_THREAD_CPUTIME_ID);
}

double process_cpu_s() {
  return clock_s(CLOCK_PROCESS_CPUTIME_ID);
}

std::uint64_t birth_stamp_ms() {
  return static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::milliseconds>(
                                        std::chrono::system_clock::now().time_since_epoch())
                                        .count());
}

void stop_on_signals() {
  struct sigaction action = {};
  action.sa_handler = note_stop;
  for (const int signal : {SIGTERM, SIGINT, SIGHUP}) sigaction(signal, &action, nullptr);
  // A launcher that died must not end us through a closed pipe before we have cleaned up.
  std::signal(SIGPIPE, SIG_IGN);
}

bool stop_requested() {
  return stop_signal != 0;
}

void end_with_parent(int parent) {
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) stop_signal = SIGTERM;
}

void Reporter::operator()(std::string_view event, nlohmann::json fields) const {
  std::string line;
  if (json_) {
    fields["event"] = event;
    if (of_) fields["of"] = of_->value;
    line = fields.dump();
  } else {
    line = fmt::format("{}: {}", who_, event);
    for (const auto& [key, value] : fields.items())
      line +=
          fmt::format("  {} {}", key, value.is_string() ? value.get<std::string>() : value.dump());
  }
  line += '\n';
  std::fwrite(line.data(), 1, line.size(), stdout);
  std::fflush(stdout);
}

int run_program(const std::function<Exit()>& body) {
  try {
    return static_cast<int>(body());
  } catch (const InputError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return static_cast<int>(Exit::bad_input);
  } catch (const RunError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return static_cast<int>(Exit::check_failed);
  } catch (const std::exception& error) {
    fmt::print(stderr, "arcbid: unexpected: {}\n", error.what());
    return static_cast<int>(Exit::check_failed);
  }
}

}  // namespace arcbid
