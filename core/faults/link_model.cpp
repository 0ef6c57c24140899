// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/faults/link_model.hpp"

#include <algorithm>
#include <cmath>

#include "core/faults/fleet.hpp"
#include "core/faults/line_of_sight.hpp"

namespace arcbid {
namespace {

constexpr TimeNs never_ns = INT64_MAX;

bool concerns(const std::vector<AgentId>& agents, AgentId agent) {
  return agents.empty() || std::find(agents.begin(), agents.end(), agent) != agents.end();
}

bool concerns(const LinkFault& fault, AgentId from, AgentId to) {
  return (concerns(fault.from, from) && concerns(fault.to, to)) ||
         (fault.both_ways && concerns(fault.from, to) && concerns(fault.to, from));
}

/// Different groups, or no group.
bool severs(const Partition& partition, AgentId from, AgentId to) {
  return std::none_of(partition.groups.begin(), partition.groups.end(), [&](const auto& group) {
    return !group.empty() && concerns(group, from) && concerns(group, to);
  });
}

/// In the window, and in a stretch of it that counts.
bool holds(const Window& when, TimeNs flap_ns, TimeNs now_ns) {
  return when.contains(now_ns) && (flap_ns <= 0 || (now_ns - when.start_ns) / flap_ns % 2 == 0);
}

double loss_at(const Reach& reach, double distance_m) {
  if (distance_m <= reach.full_m) return 0;
  if (distance_m >= reach.none_m) return 1;
  return (distance_m - reach.full_m) / (reach.none_m - reach.full_m);
}

TimeNs drawn_ns(const Delay& delay, double u) {
  switch (delay.kind) {
    case Delay::Kind::fixed:
      return delay.least_ns;
    case Delay::Kind::uniform:
      return delay.least_ns + std::llround(u * static_cast<double>(delay.most_ns - delay.least_ns));
    case Delay::Kind::exponential:
      return delay.least_ns + std::llround(-std::log1p(-u) * static_cast<double>(delay.mean_ns));
  }
  return 0;
}

}  // namespace

LinkModel::LinkModel(const FaultSchedule& schedule, const std::vector<Uav>& fleet, AgentId from,
                     AgentId to)
    : linked_(linked(schedule.topology, fleet, from, to)) {
  const Vec3 a_m = fleet[position_of(fleet, from)].home_m,
             b_m = fleet[position_of(fleet, to)].home_m;
  const TimeNs until_ns = schedule.until_ns.value_or(never_ns);
  for (std::size_t i = 0; i < schedule.links.size(); ++i) {
    LinkFault fault = schedule.links[i];
    if (!concerns(fault, from, to)) continue;
    fault.when.end_ns = std::min(fault.when.end_ns, until_ns);
    const Chance chance(schedule.seed, i, from, to);
    const double reach_loss = fault.reach ? loss_at(*fault.reach, (a_m - b_m).norm()) : 0;
    const bool in_shadow = std::any_of(fault.obstacles.begin(), fault.obstacles.end(),
                                       [&](const Obstacle& box) { return meets(box, a_m, b_m); });
    std::optional<BurstChain> burst;
    if (fault.burst) burst.emplace(*fault.burst, chance);
    effects_.push_back({std::move(fault), chance, reach_loss, in_shadow, burst});
  }
  for (const Partition& partition : schedule.partitions)
    if (severs(partition, from, to))
      cuts_.push_back({{partition.when.start_ns, std::min(partition.when.end_ns, until_ns)},
                       partition.flap_ns});
}

bool LinkModel::is_cut(TimeNs now_ns) const {
  const auto is_fault = [&](const Effect& e) {
    if (e.fault.clog && e.fault.when.end_ns == never_ns && e.fault.when.contains(now_ns))
      return true;  // held back for ever
    return e.fault.cut && holds(e.fault.when, e.fault.flap_ns, now_ns);
  };
  return std::any_of(effects_.begin(), effects_.end(), is_fault) ||
         std::any_of(cuts_.begin(), cuts_.end(),
                     [&](const Cut& cut) { return holds(cut.when, cut.flap_ns, now_ns); });
}

DropReason LinkModel::lost(std::uint64_t sequence, std::uint64_t bytes, TimeNs now_ns) {
  for (Effect& e : effects_) {
    if (!e.fault.when.contains(now_ns)) continue;
    const double loss = e.fault.loss + e.fault.loss_per_kb * static_cast<double>(bytes) / 1000;
    if (e.chance.draw(Chance::Use::loss, sequence) < loss) return DropReason::loss;
    if (e.burst && e.burst->loses(sequence)) return DropReason::burst;
    if (e.in_shadow || e.chance.draw(Chance::Use::reach, sequence) < e.reach_loss)
      return DropReason::reach;
  }
  return DropReason::none;
}

std::optional<TimeNs> LinkModel::through_queues(std::uint64_t bytes, TimeNs now_ns) {
  TimeNs due_ns = now_ns;
  for (Effect& e : effects_) {
    if (!e.fault.capacity || !e.fault.when.contains(now_ns)) continue;
    const Capacity& capacity = *e.fault.capacity;
    const double ns_per_byte = 1e9 / capacity.bytes_per_s;
    const TimeNs start_ns = std::max(due_ns, e.busy_until_ns);
    const double waiting_bytes = static_cast<double>(start_ns - due_ns) / ns_per_byte;
    if (start_ns > due_ns && capacity.queue_bytes > 0 &&
        waiting_bytes + static_cast<double>(bytes) > static_cast<double>(capacity.queue_bytes))
      return std::nullopt;
    due_ns = start_ns + std::llround(static_cast<double>(bytes) * ns_per_byte);
    e.busy_until_ns = due_ns;
  }
  return due_ns;
}

TimeNs LinkModel::arrival_ns(std::uint64_t sequence, std::uint64_t copy, TimeNs sent_ns,
                             TimeNs due_ns) const {
  TimeNs held_until_ns = due_ns;
  for (const Effect& e : effects_) {
    if (!e.fault.when.contains(sent_ns)) continue;
    if (e.fault.delay)
      due_ns += drawn_ns(*e.fault.delay, e.chance.draw(Chance::Use::delay, sequence, copy));
    if (e.fault.clog) held_until_ns = std::max(held_until_ns, e.fault.when.end_ns);
  }
  return std::max(due_ns, held_until_ns);
}

std::vector<TimeNs> LinkModel::arrivals_ns(std::uint64_t sequence, TimeNs sent_ns,
                                           TimeNs due_ns) const {
  const TimeNs first_ns = arrival_ns(sequence, 0, sent_ns, due_ns);
  std::vector<TimeNs> arrivals = {first_ns};
  for (std::size_t i = 0; i < effects_.size(); ++i) {
    const auto& [fault, chance, reach_loss, in_shadow, burst, busy_until_ns] = effects_[i];
    if (!fault.when.contains(sent_ns)) continue;
    if (chance.draw(Chance::Use::duplicate, sequence) < fault.duplicate)
      arrivals.push_back(arrival_ns(sequence, i + 1, sent_ns, due_ns));
    if (chance.draw(Chance::Use::stale, sequence) < fault.stale)
      arrivals.push_back(first_ns + fault.stale_ns);
  }
  std::sort(arrivals.begin(), arrivals.end());
  return arrivals;
}

Fate LinkModel::dropped(DropReason reason) {
  ++counters_.dropped;
  return {{}, reason};
}

Fate LinkModel::send(std::uint64_t sequence, std::uint64_t bytes, TimeNs now_ns) {
  ++counters_.sent;
  counters_.bytes += bytes;
  if (!linked_) return dropped(DropReason::no_link);
  if (is_cut(now_ns)) return dropped(DropReason::cut);
  // What is lost on the way has taken its time on the link all the same.
  const std::optional<TimeNs> due_ns = through_queues(bytes, now_ns);
  if (!due_ns) return dropped(DropReason::queue);
  if (const DropReason reason = lost(sequence, bytes, now_ns); reason != DropReason::none)
    return dropped(reason);
  Fate fate{arrivals_ns(sequence, now_ns, *due_ns), DropReason::none};
  if (fate.arrivals_ns.front() > now_ns) ++counters_.delayed;
  counters_.duplicated += fate.arrivals_ns.size() - 1;
  return fate;
}

}  // namespace arcbid
