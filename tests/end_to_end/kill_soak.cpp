// SPDX-License-Identifier: GPL-3.0-or-later
// kill -9 of a random process at a random moment of a run, many times: what was committed can be
// read and replayed, and what was lost is younger than 100 ms.
//
//   kill_soak [KILLS] [SEED]    (50, 1)
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <thread>

#include "core/base/error.hpp"
#include "core/io/process/process.hpp"
#include "sim/replay/doctor.hpp"
#include "sim/replay/run_archive.hpp"
#include "tests/auction/fleet.hpp"
#include "tests/end_to_end/launched.hpp"

namespace {

using namespace arcbid;
using testing::Launched;

constexpr double oldest_ms = 100;          // what a kill may cost
constexpr TimeNs transit_ns = 50'000'000;  // a message to the coordinator, on a busy machine
constexpr double early = 0.2;              // of the kills fall before the auction,
constexpr double window_s = 1.5;           // all so long after its beginning or the launch

/// What the launcher told the process: when time 0 was, by the host's monotonic clock. It may not
/// have come to itself yet.
TimeNs epoch_of(pid_t pid) {
  for (int tries = 0; tries < 1000; ++tries) {
    std::ifstream in(fmt::format("/proc/{}/cmdline", pid), std::ios::binary);
    std::string word;
    while (std::getline(in, word, '\0'))
      if (word == "--epoch-ns" && std::getline(in, word, '\0')) return std::stoll(word);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  throw InputError(fmt::format("process {} does not say when the run began", pid));
}

struct Kill {
  std::string process;
  TimeNs at_ns = 0;          // since launch
  std::size_t records = 0;   // committed
  double silence_ms = 0;     // since the last of them
  std::size_t messages = 0;  // heard by others, but not on record
  double oldest_ms = 0;      // how old the oldest that is known to be lost was; 0: none
  std::string problem;
  bool too_late = false;  // it had ended by itself
};

/// The coordinator says little; what it hears is known from those who said it.
void judge_coordinator(const std::filesystem::path& out, TimeNs last_ns, Kill& kill) {
  const RunArchive run = open_run(out);
  for (const LifeLog& life : run.lives)
    for (std::size_t m = 0; m < life.marks().size(); ++m) {
      const Mark& mark = life.marks()[m];
      const TimeNs heard_ns = mark.t_ns + transit_ns;
      if (mark.sent == 0 || mark.t_ns <= last_ns || heard_ns >= kill.at_ns) continue;
      if (life.step(m).update.statuses.empty()) continue;
      ++kill.messages;
      kill.oldest_ms = std::max(kill.oldest_ms, static_cast<double>(kill.at_ns - heard_ns) / 1e6);
    }
}

void judge(const std::filesystem::path& out, pid_t pid, Kill& kill) {
  for (const LogReport& log : examine(out).logs) {
    if (log.pid != static_cast<std::uint64_t>(pid)) continue;
    kill.too_late = log.ended_by.has_value();
    kill.records = log.records;
    if (log.records > 0) kill.silence_ms = static_cast<double>(kill.at_ns - log.last_ns) / 1e6;
    if (log.heard_only) {
      kill.messages = log.heard_only->messages;
      kill.oldest_ms = static_cast<double>(kill.at_ns - log.heard_only->first_ns) / 1e6;
    }
    if (log.role == "coordinator" && log.records > 0) judge_coordinator(out, log.last_ns, kill);
  }
  if (kill.oldest_ms > oldest_ms) kill.problem = "it lost more than its last 100 ms";
}

/// `arcbid` with these arguments must end with 0.
void demand(const std::vector<std::string>& arguments, Kill& kill) {
  Launched command(arguments);
  const auto code = command.wait_for_end(60);
  if (code == 0) return;
  if (command.output().find("no agent's log has the mission") != std::string::npos) return;
  kill.problem =
      fmt::format("{} ended with {}: {}", arguments[0], code.value_or(-99), command.output());
}

Kill kill_one(std::uint64_t seed) {
  const testing::Scratch scratch;
  const std::filesystem::path out = scratch / "run";
  Launched run({"run", std::string(ARCBID_SOURCE_DIR) + "/configs/storm.yaml", "--faults",
                "lossy_30", "--out", out.string()});
  const auto processes = testing::processes_of(out);
  testing::Dice dice(seed);
  auto victim = processes.begin();
  std::advance(victim, dice.below(processes.size()));
  Kill kill;
  kill.process = victim->first;
  const TimeNs epoch_ns = epoch_of(victim->second);
  if (dice.unit() >= early) run.wait_for("bidding for", 30);
  std::this_thread::sleep_for(std::chrono::duration<double>(window_s * dice.unit()));
  ::kill(victim->second, SIGKILL);
  kill.at_ns = monotonic_ns() - epoch_ns;
  const auto code = run.wait_for_end(90);
  // 1: the coordinator died before there was a mission.
  if (code != 0 && code != 1) kill.problem = "the run did not end: " + run.output();
  try {
    judge(out, victim->second, kill);
  } catch (const InputError& error) {
    kill.problem = error.what();
  }
  demand({"doctor", out.string()}, kill);
  demand({"replay", out.string(), "--verify"}, kill);
  return kill;
}

}  // namespace

int main(int argc, char** argv) {
  const int kills = argc > 1 ? std::atoi(argv[1]) : 50;
  const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  int bad = 0;
  std::vector<double> oldest;
  fmt::print("process        at s  records  silent ms  unrecorded  oldest ms\n");
  std::uint64_t tries = seed * 1000;
  for (int n = 0; n < kills; ++n) {
    Kill kill;
    do kill = kill_one(tries++);
    while (kill.too_late);
    fmt::print("{:<12} {:>6.2f} {:>8} {:>10.1f} {:>11} {:>10.1f}  {}\n", kill.process,
               static_cast<double>(kill.at_ns) / 1e9, kill.records, kill.silence_ms, kill.messages,
               kill.oldest_ms, kill.problem);
    std::fflush(stdout);
    bad += kill.problem.empty() ? 0 : 1;
    if (kill.oldest_ms > 0) oldest.push_back(kill.oldest_ms);
  }
  std::sort(oldest.begin(), oldest.end());
  if (!oldest.empty())
    fmt::print(
        "known to have lost something: {} of {}; its age, median {:.1f} ms, most {:.1f} ms\n",
        oldest.size(), kills, oldest[oldest.size() / 2], oldest.back());
  fmt::print("{} kills, {} of them with a problem\n", kills, bad);
  return bad == 0 ? 0 : 1;
}
