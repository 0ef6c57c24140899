// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "sim/world/mission_maker.hpp"

namespace arcbid {
namespace {

constexpr TimeNs ms = 1'000'000;

/// Draws the faults of one world.
class FaultMaker {
 public:
  FaultMaker(const WorldSettings& settings, const Mission& mission, Dice& dice)
      : settings_(settings), mission_(mission), dice_(dice) {
    for (const Uav& uav : mission.fleet) untouched_.push_back(uav.id);
  }

  FaultSchedule make(std::uint64_t seed) {
    schedule_.name = settings_.name;
    schedule_.seed = seed;
    schedule_.until_ns = settings_.until_ns;
    make_topology();
    for (std::size_t kind = 0; kind < settings_.odds.size(); ++kind)
      if (dice_.chance(settings_.odds[kind])) add(static_cast<WorldFault>(kind));
    return schedule_;
  }

 private:
  void make_topology() {
    const auto last = static_cast<std::uint32_t>(settings_.topologies.size() - 1);
    schedule_.topology.kind = settings_.topologies[dice_.between(0, last)];
    const double radius_m = dice_.within(30, 90);
    if (schedule_.topology.kind == TopologyKind::geometric) schedule_.topology.radius_m = radius_m;
  }

  void add(WorldFault kind) {
    if (kind < WorldFault::partition)
      schedule_.links.push_back(link_fault(kind));
    else if (kind == WorldFault::partition)
      add_partition();
    else
      add_agent_fault(kind);
  }

  Window window() {
    const TimeNs start = dice_.chance(0.5) ? 0 : dice_.time_ns(0, settings_.until_ns / 2);
    return {start, dice_.time_ns(start + settings_.until_ns / 10, settings_.until_ns)};
  }

  std::vector<AgentId> some_agents() {
    std::vector<AgentId> some;
    for (const Uav& uav : mission_.fleet)
      if (dice_.chance(0.4)) some.push_back(uav.id);
    return some;
  }

  LinkFault link_fault(WorldFault kind) {
    LinkFault fault;
    const double loss = dice_.within(settings_.loss.least, settings_.loss.most);
    if (kind == WorldFault::loss) {
      fault.loss = loss;
      return fault;
    }
    if (dice_.chance(0.5)) fault.from = some_agents();
    if (dice_.chance(0.5)) fault.to = some_agents();
    fault.both_ways = dice_.chance(0.3);
    fault.when = window();
    fill(kind, loss, fault);
    return fault;
  }

  void fill(WorldFault kind, double loss, LinkFault& fault) {
    switch (kind) {
      case WorldFault::burst:
        fault.burst = Burst{.mean_loss = loss, .mean_length = dice_.within(2, 20)};
        break;
      case WorldFault::size_loss:
        fault.loss_per_kb = dice_.within(0.1, 0.8);
        break;
      case WorldFault::delay:
        fault.delay = delay();
        break;
      case WorldFault::duplicate:
        fault.duplicate = dice_.within(0.05, 0.6);
        break;
      case WorldFault::stale:
        fault.stale = dice_.within(0.01, 0.2);
        fault.stale_ns = dice_.time_ns(50 * ms, 1500 * ms);
        break;
      case WorldFault::capacity:
        fault.capacity = Capacity{dice_.within(20'000, 200'000), dice_.between(1'000, 20'000)};
        break;
      case WorldFault::reach:
        fault.reach = Reach{dice_.within(10, 40), dice_.within(60, 150)};
        break;
      case WorldFault::obstacle:
        fault.obstacles.push_back(box());
        break;
      case WorldFault::clog:
        fault.clog = true;
        break;
      default:  // cut and flap
        fault.cut = true;
        if (kind == WorldFault::flap) fault.flap_ns = dice_.time_ns(30 * ms, 600 * ms);
    }
  }

  Delay delay() {
    Delay delay;
    delay.least_ns = dice_.time_ns(0, 60 * ms);
    delay.kind = static_cast<Delay::Kind>(dice_.between(0, 2));
    const TimeNs most = delay.least_ns + dice_.time_ns(0, 200 * ms);
    const TimeNs mean = dice_.time_ns(5 * ms, 80 * ms);
    if (delay.kind == Delay::Kind::uniform) delay.most_ns = most;
    if (delay.kind == Delay::Kind::exponential) delay.mean_ns = mean;
    return delay;
  }

  Obstacle box() {
    const Vec3 least(dice_.within(0, 80), dice_.within(0, 80), -1);
    return {least, least + Vec3(dice_.within(5, 30), dice_.within(5, 30), 40)};
  }

  void add_partition() {
    Partition partition{.groups = {{}, {}}, .when = window()};
    for (const Uav& uav : mission_.fleet) partition.groups[dice_.between(0, 1)].push_back(uav.id);
    std::erase_if(partition.groups, [](const auto& group) { return group.empty(); });
    if (dice_.chance(0.2)) partition.flap_ns = dice_.time_ns(100 * ms, 800 * ms);
    schedule_.partitions.push_back(partition);
  }

  /// Every agent has one fault at most, and one agent has none: somebody is always there.
  void add_agent_fault(WorldFault kind) {
    if (untouched_.size() < 2) return;
    const auto last = static_cast<std::uint32_t>(untouched_.size() - 1);
    const auto chosen = untouched_.begin() + dice_.between(0, last);
    AgentFault fault;
    fault.agent = *chosen;
    untouched_.erase(chosen);
    fault.at_ns = dice_.time_ns(0, settings_.until_ns * 3 / 4);
    fault.for_ns = dice_.time_ns(20 * ms, settings_.until_ns - fault.at_ns);
    fill(kind, fault);
    schedule_.agents.push_back(fault);
    if (kind == WorldFault::clock_step_back) add_step_back(fault);
  }

  void fill(WorldFault kind, AgentFault& fault) {
    switch (kind) {
      case WorldFault::crash:
        fault.for_ns.reset();
        break;
      case WorldFault::pause:
        fault.kind = AgentFaultKind::pause;
        break;
      case WorldFault::late:
        fault.kind = AgentFaultKind::late;
        fault.at_ns = 0;
        break;
      case WorldFault::clock:
        fault.kind = AgentFaultKind::clock;
        fault.offset_ns = dice_.time_ns(-300 * ms, 300 * ms);
        fault.drift = dice_.within(-0.1, 0.1);
        break;
      case WorldFault::twin:
        fault.kind = AgentFaultKind::twin;
        break;
      case WorldFault::malformed:
        fault.kind = AgentFaultKind::malformed;
        fault.malformation = dice_.chance(0.2) ? Malformation::replay
                                               : static_cast<Malformation>(dice_.between(0, 4));
        fault.count = dice_.between(1, 10);
        fault.for_ns.reset();
        break;
      case WorldFault::over_bid:
        fault.kind = AgentFaultKind::malformed;
        fault.malformation = Malformation::over_bid;
        fault.for_ns = dice_.time_ns(20 * ms, 200 * ms);
        break;
      default:  // crash_return and clock_step_back: back after for_ns
        break;
    }
  }

  /// The clock goes back before the agent does come back, and is right again later.
  void add_step_back(const AgentFault& crash) {
    AgentFault clock;
    clock.agent = crash.agent;
    clock.kind = AgentFaultKind::clock;
    clock.at_ns = crash.at_ns;
    clock.for_ns = settings_.until_ns - crash.at_ns;
    clock.offset_ns = -crash.at_ns - dice_.time_ns(0, 5000 * ms);
    schedule_.agents.push_back(clock);
  }

  const WorldSettings& settings_;
  const Mission& mission_;
  Dice& dice_;
  std::vector<AgentId> untouched_;
  FaultSchedule schedule_;
};

}  // namespace

FaultSchedule make_faults(const WorldSettings& settings, const Mission& mission, std::uint64_t seed,
                          Dice& dice) {
  return FaultMaker(settings, mission, dice).make(seed);
}

}  // namespace arcbid
