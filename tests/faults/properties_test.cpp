// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <fstream>
#include <sstream>

#include "core/base/error.hpp"
#include "core/io/faults/fault_files.hpp"

namespace arcbid {
namespace {

constexpr TimeNs ms = 1'000'000, s = 1000 * ms;

double number(double low, double high) {
  const auto share = static_cast<double>(*rc::gen::inRange<std::uint64_t>(0, 1ULL << 53));
  return std::min(high, low + (high - low) * share / static_cast<double>(1ULL << 53));
}

TimeNs time_ns(TimeNs low_ns, TimeNs high_ns) {
  return *rc::gen::inRange(low_ns, high_ns + 1);
}

bool maybe() {
  return *rc::gen::arbitrary<bool>();
}

Window window() {
  Window when{time_ns(0, 40'000 * s), INT64_MAX};
  if (maybe()) when.end_ns = time_ns(when.start_ns + 1, 86'400 * s);
  return when;
}

std::vector<AgentId> ids() {
  const auto numbers = *rc::gen::unique<std::vector<std::uint32_t>>(rc::gen::inRange(1u, 60u));
  std::vector<AgentId> list;
  for (const std::uint32_t n : numbers) list.push_back({n});
  return list;
}

Delay delay() {
  using K = Delay::Kind;
  Delay d;
  d.kind = *rc::gen::element(K::fixed, K::uniform, K::exponential);
  d.least_ns = time_ns(0, 300 * s);
  if (d.kind == K::uniform) d.most_ns = time_ns(d.least_ns, 600 * s);
  if (d.kind == K::exponential) d.mean_ns = time_ns(1, 600 * s);
  return d;
}

LinkFault link_fault(bool has_end) {
  LinkFault fault;
  fault.from = ids();
  fault.to = ids();
  fault.both_ways = maybe();
  fault.when = window();
  fault.loss = number(0.001, 1);
  if (maybe()) fault.loss_per_kb = number(0, 1);
  if (maybe())
    fault.burst = Burst{number(0.1, 0.5), number(6, 1000), number(0, 0.1), number(0.6, 1)};
  if (maybe()) fault.reach = Reach{number(0, 100), number(100, 1e6)};
  if (maybe()) fault.obstacles = {{Vec3(number(-1e6, 0), -1, 0), Vec3(number(0, 1e6), 0, 0)}};
  if (maybe()) fault.delay = delay();
  if (maybe()) fault.duplicate = number(0, 1);
  if (maybe()) {
    fault.stale = number(0.001, 1);
    fault.stale_ns = time_ns(1, 86'400 * s);
  }
  if (maybe())
    fault.capacity = Capacity{number(1, 1e12), *rc::gen::inRange<std::uint64_t>(0, 1'000'000'000)};
  fault.clog = maybe() && (has_end || fault.when.end_ns != INT64_MAX);
  fault.cut = maybe();
  if (fault.cut) fault.flap_ns = time_ns(0, 86'400 * s);
  return fault;
}

Partition partition() {
  Partition p{{{{*rc::gen::inRange(100u, 200u)}}}, window(), time_ns(0, 100 * s)};
  if (const auto group = ids(); !group.empty()) p.groups.push_back(group);
  return p;
}

AgentFault agent_fault(std::uint32_t id) {
  using K = AgentFaultKind;
  using M = Malformation;
  AgentFault fault;
  fault.agent = {id};
  fault.kind = *rc::gen::element(K::crash, K::pause, K::late, K::clock, K::twin, K::malformed);
  if (id == 0) fault.kind = *rc::gen::element(K::crash, K::pause);
  if (fault.kind != K::late) fault.at_ns = time_ns(0, 86'400 * s);
  if (fault.kind == K::late || (fault.kind != K::malformed && maybe()))
    fault.for_ns = time_ns(ms, 86'400 * s);
  if (fault.kind == K::clock) {
    fault.offset_ns = time_ns(-86'400 * s, 86'400 * s);
    fault.drift = number(0.001, 0.5);
  }
  if (fault.kind == K::malformed) {
    fault.malformation =
        *rc::gen::element(M::nan_bid, M::unknown_task, M::unknown_agent, M::wrong_mission,
                          M::wrong_tasks, M::over_bid, M::replay);
    fault.count = *rc::gen::inRange(1u, 100'001u);
  }
  return fault;
}

/// Any legal schedule.
FaultSchedule legal_schedule() {
  using T = TopologyKind;
  FaultSchedule schedule;
  schedule.name = maybe() ? "a: 'name' #1" : "";
  schedule.seed = *rc::gen::arbitrary<std::uint32_t>();
  if (maybe()) schedule.until_ns = time_ns(40'001 * s, 86'400 * s);
  schedule.topology.kind = *rc::gen::element(T::complete, T::ring, T::line, T::star, T::geometric);
  if (schedule.topology.kind == T::geometric) schedule.topology.radius_m = number(0.1, 1e6);
  for (int n = *rc::gen::inRange(0, 4); n > 0; --n)
    schedule.links.push_back(link_fault(schedule.until_ns.has_value()));
  for (int n = *rc::gen::inRange(0, 3); n > 0; --n) schedule.partitions.push_back(partition());
  for (std::uint32_t id = 0; id < *rc::gen::inRange(0u, 8u); ++id)
    schedule.agents.push_back(agent_fault(id));
  return schedule;
}

TEST(FaultProperty, PrintedSchedulesReadBackTheSame) {
  EXPECT_TRUE(rc::check("parse(to_yaml(s)) == s", [] {
    const FaultSchedule schedule = legal_schedule();
    RC_LOG(to_yaml(schedule));
    RC_ASSERT(parse_faults(to_yaml(schedule), "printed.yaml") == schedule);
  }));
}

/// Cuts, repeats, and overwrites pieces of `text`.
std::string mutated(std::string text) {
  static const std::vector<std::string> pieces = {
      "\n", "\t", ": ",  "- ", "[",    "]",    "{",  "}",    "\"", "#",    "&a ", "*a",
      "!!", "? ", "---", "~",  ".nan", "1e99", "-1", "\xff", ",",  "null", "any", "0"};
  for (int n = *rc::gen::inRange(1, 6); n > 0; --n) {
    const auto at = *rc::gen::inRange<std::size_t>(0, text.size() + 1);
    const auto length = *rc::gen::inRange<std::size_t>(0, 30);
    switch (*rc::gen::inRange(0, 3)) {
      case 0:
        text.erase(at, length);
        break;
      case 1:
        text.insert(at, text.substr(at, length));
        break;
      default:
        text.insert(at, *rc::gen::elementOf(pieces));
    }
  }
  return text;
}

TEST(FaultProperty, DamagedFilesAreReadOrRefused) {
  std::ifstream in(std::filesystem::path(ARCBID_SOURCE_DIR) / "configs/faults/example.yaml");
  std::ostringstream text;
  text << in.rdbuf();
  int accepted = 0, refused = 0;
  EXPECT_TRUE(rc::check("schedule or InputError", [&] {
    for (int i = 0; i < 10; ++i) try {
        const FaultSchedule schedule = parse_faults(mutated(text.str()), "damaged.yaml");
        RC_ASSERT(parse_faults(to_yaml(schedule), "damaged.yaml") == schedule);
        ++accepted;
      } catch (const InputError& e) {
        RC_ASSERT(std::string(e.what()).starts_with("damaged.yaml"));
        ++refused;
      }
  }));
  EXPECT_GT(accepted, 10);
  EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace arcbid
