// SPDX-License-Identifier: GPL-3.0-or-later
// What it costs to open, seek in and verify a run of so many events: replay_bench [EVENTS].
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <filesystem>

#include "sim/replay/playback.hpp"
#include "sim/replay/verify.hpp"
#include "tests/replay/recorded_fleet.hpp"

namespace {

using namespace arcbid;
using namespace arcbid::testing;

double seconds_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::uintmax_t bytes_of(const std::filesystem::path& folder) {
  std::uintmax_t bytes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) bytes += entry.file_size();
  return bytes;
}

/// Agreements, and now and then a death and a return, which open them again.
void record(const std::filesystem::path& folder, std::uint64_t events) {
  constexpr std::uint32_t agents = 8, arcs = 40;
  RecordedFleet fleet(random_mission(1, agents, arcs), folder, 1);
  const std::uint64_t turn = std::max<std::uint64_t>(events / 20, 1);
  for (std::uint64_t deaths = 0; fleet.steps() < events;) {
    fleet.step_once();
    if (fleet.steps() < (deaths + 1) * turn) continue;
    const AgentId one{static_cast<std::uint32_t>(deaths++ % agents + 1)};
    fleet.kill(one);
    fleet.revive(one);
  }
  fleet.end();
}

void measure_seeks(const Playback& playback) {
  Dice dice(2);
  std::vector<double> took_ms;
  for (int n = 0; n < 100; ++n) {
    const std::size_t moments = dice.below(playback.moments().size());
    took_ms.push_back(1e3 * seconds_of([&] {
                        const auto states = playback.agents(moments);
                        playback.owners(moments);
                        for (const Playback::AgentState& state : states)
                          if (state.life) playback.beliefs(*state.life, state.steps);
                      }));
  }
  std::sort(took_ms.begin(), took_ms.end());
  fmt::print("seek          median {:.2f} ms, worst {:.2f} ms of {}\n", took_ms[took_ms.size() / 2],
             took_ms.back(), took_ms.size());
}

}  // namespace

int main(int argc, char** argv) {
  const std::uint64_t events = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1'000'000;
  const TemporaryFolder folder;
  fmt::print("record        {:.2f} s\n", seconds_of([&] { record(folder.path(), events); }));
  fmt::print("logs          {:.1f} MB\n",
             static_cast<double>(bytes_of(folder.path() / "logs")) * 1e-6);
  std::optional<RunArchive> run;
  std::optional<Playback> playback;
  const std::clock_t before = std::clock();
  const double opened_s = seconds_of([&] { run = open_run(folder.path()); });
  const double ordered_s = seconds_of([&] { playback.emplace(*run); });
  fmt::print("open          {:.2f} s: {:.2f} s for {} logs, {:.2f} s for the order of {} events\n",
             opened_s + ordered_s, opened_s, run->lives.size(), ordered_s,
             playback->moments().size());
  fmt::print("              {:.2f} s of processor time\n",
             static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC);
  measure_seeks(*playback);
  std::size_t steps = 0;
  const double verified_s = seconds_of([&] {
    for (const LifeLog& life : run->lives) steps += verify(life).steps;
  });
  fmt::print("verify        {} steps, {:.0f} a second, one thread\n", steps,
             static_cast<double>(steps) / verified_s);
  return steps == playback->moments().size() ? 0 : 1;
}
