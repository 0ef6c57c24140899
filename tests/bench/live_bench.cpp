// SPDX-License-Identifier: GPL-3.0-or-later
// Time to agreement on live processes beside what the network alone would take: rounds needed times
// the latency of one hop, both of this machine. 8 agents, each a process, about 500 tasks, no loss.
//
//   live_bench [RUNS]    (10)
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "core/io/domain/domain.hpp"
#include "core/io/mission/mission_plan.hpp"
#include "core/io/process/process.hpp"
#include "idl/bus.hpp"
#include "tests/auction/fleet.hpp"

namespace {

using namespace arcbid;
using namespace std::chrono_literals;

const std::string config_file = std::string(ARCBID_SOURCE_DIR) + "/configs/quick8.yaml";

/// A bid as large as they are on average when all is agreed.
BidMessage bid_of(std::uint32_t agent, std::uint64_t round, std::size_t claims) {
  BidMessage bid;
  bid.header = {{agent}, 1, round, 1, 1};
  bid.statement = {{agent}, {1, false, static_cast<std::uint32_t>(round)}, Claims{}};
  auto& bundle = std::get<Claims>(bid.statement.body).bundle;
  for (std::uint32_t n = 0; n < claims; ++n) bundle.push_back({{n}, 1.0});
  return bid;
}

struct Hop {
  double alone_s = 0;     ///< half of a round trip between two, nobody else speaks
  double exchange_s = 0;  ///< all speak at once until each has heard all others
};

/// One process of the fleet that only speaks. All speak in turns: a round is over for it when it
/// has heard everybody's.
class Speaker {
 public:
  Speaker(std::uint32_t domain, std::uint32_t id, std::uint32_t agents, std::size_t claims)
      : id_(id), claims_(claims), heard_(agents + 1, 0), bus_({}, domain, AgentId{id}, agents) {
    const TimeNs limit_ns = monotonic_ns() + 30'000'000'000;
    while (bus_.matched_agents() + 1 < agents && monotonic_ns() < limit_ns) bus_.wait(10ms);
  }

  Hop measure() {
    for (std::uint64_t round = 1; round <= 50; ++round) exchange(round);
    TimeNs start_ns = monotonic_ns();
    constexpr std::uint64_t rounds = 300;
    for (std::uint64_t round = 51; round <= 50 + rounds; ++round) exchange(round);
    const double exchange_s = static_cast<double>(monotonic_ns() - start_ns) * 1e-9 / rounds;
    start_ns = monotonic_ns();
    for (std::uint64_t round = 1001; round <= 1000 + rounds; ++round) ping(round);
    return {static_cast<double>(monotonic_ns() - start_ns) * 1e-9 / (2 * rounds), exchange_s};
  }

 private:
  void say(std::uint64_t round) { bus_.publish(bid_of(id_, round, claims_)); }

  void hear(std::chrono::nanoseconds timeout) {
    for (const Received& received : bus_.wait(timeout))
      if (const auto* bid = std::get_if<BidMessage>(&received)) {
        std::uint64_t& last = heard_[bid->header.sender.value];
        last = std::max(last, bid->header.sequence);
      }
  }

  void exchange(std::uint64_t round) {
    say(round);
    const auto all_heard = [&] {
      for (std::size_t k = 1; k < heard_.size(); ++k)
        if (k != id_ && heard_[k] < round) return false;
      return true;
    };
    for (int tries = 0; !all_heard() && tries < 100; ++tries) {
      hear(50ms);
      if (tries > 10) say(round);  // it may have been lost
    }
  }

  /// The first two only: one asks, the other answers.
  void ping(std::uint64_t round) {
    if (id_ > 2) return;
    const std::uint32_t other = 3 - id_;
    if (id_ == 1) say(round);
    for (int tries = 0; heard_[other] < round && tries < 100; ++tries) hear(50ms);
    if (id_ == 2) say(round);
  }

  std::uint32_t id_;
  std::size_t claims_;
  std::vector<std::uint64_t> heard_;
  Bus bus_;
};

/// Medians over the processes; of the pings, what the two that did them measured.
Hop measure_hop(std::uint32_t agents, std::size_t claims) {
  const DomainLease lease(agents);
  std::array<int, 2> pipe_ends{};
  if (pipe(pipe_ends.data()) != 0) return {};
  for (std::uint32_t id = 1; id <= agents; ++id) {
    if (fork() != 0) continue;
    alarm(60);
    const Hop hop = Speaker(lease.domain(), id, agents, claims).measure();
    const std::array<double, 3> line{static_cast<double>(id), hop.alone_s, hop.exchange_s};
    _exit(write(pipe_ends[1], line.data(), sizeof line) == sizeof line ? 0 : 1);
  }
  close(pipe_ends[1]);
  Hop out;
  std::vector<double> exchanges;
  for (std::array<double, 3> line; read(pipe_ends[0], line.data(), sizeof line) == sizeof line;) {
    exchanges.push_back(line[2]);
    if (line[0] < 2) out.alone_s = line[1];
  }
  while (wait(nullptr) > 0) continue;
  std::sort(exchanges.begin(), exchanges.end());
  if (!exchanges.empty()) out.exchange_s = exchanges[exchanges.size() / 2];
  return out;
}

/// Rounds until all have proof when every message takes exactly one round.
double rounds_needed(const Mission& mission) {
  constexpr TimeNs hop_ns = 1'000'000'000;
  Mission paced = mission;
  paced.auction.tick_ns = 2 * hop_ns;  // rounds are ended by what is heard, not by the clock
  paced.auction.lease_ns = 3600 * hop_ns;
  testing::Fleet fleet(paced, {.loss = 0, .duplicate = 0, .least_ns = hop_ns, .most_ns = hop_ns},
                       1);
  if (!fleet.run(3600 * hop_ns)) return 0;
  return static_cast<double>(fleet.now_ns()) / hop_ns;
}

/// From the first bid to the last proof, in seconds; 0: the run failed.
double live_run(const std::filesystem::path& out) {
  const std::string command = fmt::format("{}/arcbid run {} --out {} > {}.txt", ARCBID_BIN_DIR,
                                          config_file, out.string(), out.string());
  if (std::system(command.c_str()) != 0) return 0;
  std::ifstream file(out / "result.json");
  return nlohmann::json::parse(file).at("agreement").at("auction_s");
}

}  // namespace

int main(int argc, char** argv) {
  const int runs = argc > 1 ? std::atoi(argv[1]) : 10;
  const Config config = load_config(config_file);
  const Mission mission = plan_mission(config, 1).mission;
  const double rounds = rounds_needed(mission);
  const std::size_t tasks =
      split(mission.arcs, mission.auction.split_m, mission.auction.max_tasks).tasks.size();
  const Hop hop = measure_hop(config.fleet.agents, tasks / config.fleet.agents);
  fmt::print("{} agents, {} tasks: {:.0f} rounds needed (to proof, virtual network)\n",
             config.fleet.agents, tasks, rounds);
  fmt::print(
      "one hop of a bid of {} claims: {:.3f} ms between two when nobody else speaks, {:.3f} ms "
      "when all speak\n",
      tasks / config.fleet.agents, 1e3 * hop.alone_s, 1e3 * hop.exchange_s);
  const auto folder =
      std::filesystem::temp_directory_path() / fmt::format("live_bench.{}", getpid());
  std::filesystem::create_directories(folder);
  std::vector<double> times;
  for (int run = 0; run < runs; ++run) times.push_back(live_run(folder / std::to_string(run)));
  std::filesystem::remove_all(folder);
  std::sort(times.begin(), times.end());
  const double median = times[times.size() / 2];
  fmt::print("first bid to last proof, {} runs: {:.1f} ms median, {:.1f} to {:.1f}\n", runs,
             1e3 * median, 1e3 * times.front(), 1e3 * times.back());
  fmt::print("of rounds x hop: {:.2f} (all speak), {:.2f} (alone)\n",
             median / (rounds * hop.exchange_s), median / (rounds * hop.alone_s));
}
