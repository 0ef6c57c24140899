// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/auction/fleet.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/digest.hpp"

namespace arcbid::testing {

double Dice::unit() {
  state_ += 0x9e3779b97f4a7c15ULL;
  return static_cast<double>(Digest::mix(state_) >> 11) * 0x1p-53;
}

Mission random_mission(std::uint64_t seed, std::uint32_t agents, std::uint32_t arcs) {
  Dice dice(seed);
  const auto point = [&] { return Vec3(100 * dice.unit(), 100 * dice.unit(), 30 * dice.unit()); };
  Mission mission{.id = seed + 1,
                  .name = "random",
                  .arcs = {},
                  .fleet = {},
                  .airspace = {},
                  .auction = {},
                  .tour = {}};
  for (std::uint32_t m = 0; m < arcs; ++m) {
    const Vec3 start = point();
    const Vec3 along = Vec3(dice.unit() - 0.5, dice.unit() - 0.5, 0.1).normalized();
    const double length = 5 + 20 * dice.unit();
    mission.arcs.push_back(
        {{m}, ArcKind::outline, {{start, Vec3::UnitX()}, {start + length * along, Vec3::UnitX()}}});
  }
  for (std::uint32_t i = 1; i <= agents; ++i)
    mission.fleet.push_back({{i}, Vec3(100 * dice.unit(), 100 * dice.unit(), 0), 1 + dice.unit()});
  mission.auction.split_m = 10;
  return mission;
}

Fleet::Fleet(Mission mission, Link link, std::uint64_t seed)
    : mission_(std::make_shared<const Mission>(std::move(mission))), link_(link), dice_(seed) {
  for (const Uav& uav : mission_->fleet) revive(uav.id);
}

void Fleet::revive(AgentId id) {
  Member& member = members_[id];
  // A clock at birth: grows with every life and differs between agents.
  const std::uint64_t incarnation =
      1000 + static_cast<std::uint64_t>(now_ns_ / 1'000'000) + id.value;
  member.agent = std::make_unique<Agent>(id, incarnation + member.lives++, mission_,
                                         std::make_shared<StraightTransit>(), now_ns_);
  member.agreement.reset();
  member.wake_ns = now_ns_;
}

void Fleet::kill(AgentId id) {
  members_.at(id).agent.reset();
  members_.at(id).agreement.reset();
}

std::vector<AgentId> Fleet::living() const {
  std::vector<AgentId> living;
  for (const auto& [id, member] : members_)
    if (member.agent) living.push_back(id);
  return living;
}

template <class Message>
void Fleet::broadcast(AgentId from, const Message& message) {
  ++messages_;
  for (const auto& [to, member] : members_) {
    if (to == from || !member.agent) continue;
    if (!sides_.empty() && sides_[to] != sides_[from]) continue;
    if (dice_.unit() < link_.loss) continue;
    for (int copies = dice_.unit() < link_.duplicate ? 2 : 1; copies > 0; --copies) {
      const double spread = static_cast<double>(link_.most_ns - link_.least_ns);
      const TimeNs at = now_ns_ + link_.least_ns + static_cast<TimeNs>(dice_.unit() * spread);
      queue_.emplace(std::pair(at, order_), Delivery{at, order_, to, {at, message}});
      ++order_;
    }
  }
}

void Fleet::carry_out(AgentId from, Update update) {
  Member& member = members_.at(from);
  member.wake_ns = update.wake_ns;
  if (update.agreement_lost) member.agreement.reset();
  for (const auto& bid : update.bids) broadcast(from, bid);
  for (const auto& relay : update.relays) broadcast(from, relay);
  for (const auto& status : update.statuses) broadcast(from, status);
  if (update.agreed) member.agreement = std::move(update.agreed);
}

void Fleet::step_once() {
  TimeNs next = queue_.empty() ? std::numeric_limits<TimeNs>::max() : queue_.begin()->first.first;
  std::optional<AgentId> waking;
  for (const auto& [id, member] : members_)
    if (member.agent && member.wake_ns < next) {
      next = member.wake_ns;
      waking = id;
    }
  now_ns_ = std::max(now_ns_, next);
  if (waking) {
    const Tick tick{static_cast<std::uint32_t>(members_.size() - 1)};
    carry_out(*waking, members_.at(*waking).agent->step({now_ns_, tick}));
    return;
  }
  const Delivery delivery = queue_.begin()->second;
  queue_.erase(queue_.begin());
  Member& member = members_.at(delivery.to);
  if (member.agent) carry_out(delivery.to, member.agent->step(delivery.event));
}

bool Fleet::agreed() const {
  std::optional<std::uint64_t> hash;
  for (const auto& [id, member] : members_) {
    if (!member.agent) continue;
    if (!member.agreement) return false;
    if (hash && *hash != member.agreement->view_hash) return false;
    hash = member.agreement->view_hash;
  }
  return hash.has_value();
}

bool Fleet::run(TimeNs limit_ns) {
  const TimeNs end = now_ns_ + limit_ns;
  while (now_ns_ < end && !agreed()) step_once();
  return agreed();
}

void Fleet::run_for(TimeNs span_ns) {
  const TimeNs end = now_ns_ + span_ns;
  while (now_ns_ < end) step_once();
}

namespace {

/// Seconds of the closed tour; the plainest possible reading of MiniMax.
double tour_s(const Uav& uav, const TaskSet& set, const std::vector<PathStop>& path) {
  Vec3 at = uav.home_m;
  double metres = 0;
  for (const PathStop& stop : path) {
    const Task& task = set.tasks[stop.task.value];
    metres += ((stop.reversed ? task.last_m : task.first_m) - at).norm() + task.length_m();
    at = stop.reversed ? task.first_m : task.last_m;
  }
  return (metres + (uav.home_m - at).norm()) / uav.speed_mps;
}

struct Offer {
  double score = -std::numeric_limits<double>::infinity();
  std::vector<PathStop> path;
};

Offer best_offer(const Uav& uav, const TaskSet& set, const std::vector<PathStop>& path, TaskId j) {
  Offer best;
  for (std::size_t l = 0; l <= path.size(); ++l)
    for (const bool reversed : {false, true}) {
      std::vector<PathStop> longer = path;
      longer.insert(longer.begin() + static_cast<std::ptrdiff_t>(l), {j, reversed});
      const double score = -tour_s(uav, set, longer);
      if (uav.endurance_s && -score > *uav.endurance_s) continue;
      if (score > best.score + 1e-9) best = {score, longer};
    }
  return best;
}

}  // namespace

std::vector<Belief> sequential_greedy(const Mission& mission, const TaskSet& set,
                                      const std::vector<AgentId>& agents) {
  std::vector<Belief> winners(set.tasks.size());
  std::map<AgentId, std::vector<PathStop>> paths;
  for (std::size_t assigned = 0; assigned < set.tasks.size(); ++assigned) {
    Offer best;
    AgentId who;
    TaskId what;
    for (const Uav& uav : mission.fleet) {
      if (std::find(agents.begin(), agents.end(), uav.id) == agents.end()) continue;
      for (const Task& task : set.tasks) {
        if (winners[task.id.value].winner || !serves(uav.payload, task.payload)) continue;
        const Offer offer = best_offer(uav, set, paths[uav.id], task.id);
        if (offer.score > best.score + 1e-9) best = offer, who = uav.id, what = task.id;
      }
    }
    if (best.path.empty()) break;  // nobody can fly any more
    winners[what.value] = {who, best.score};
    paths[who] = best.path;
  }
  return winners;
}

}  // namespace arcbid::testing
