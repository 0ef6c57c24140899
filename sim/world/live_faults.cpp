// SPDX-License-Identifier: GPL-3.0-or-later
// What really happened to the processes of a live run, as a fault schedule.
#include <algorithm>
#include <utility>

#include "core/base/error.hpp"
#include "sim/world/live_run.hpp"

namespace arcbid {
namespace {

/// When the run was over: nobody has logged anything later.
TimeNs end_ns(const LiveRun& run) {
  TimeNs end = 0;
  for (const LiveLife& life : run.lives) end = std::max(end, life.last_ns);
  return end;
}

/// Writes down what one agent went through.
class History {
 public:
  History(const LiveRun& run, AgentId agent, std::vector<AgentFault>& out)
      : run_(run), agent_(agent), out_(out) {
    for (const LiveLife& life : run.lives)
      if (life.agent == agent) (life.is_twin ? twins_ : lives_).push_back(life);
  }

  /// Returns whether the agent was there at the end.
  bool write() {
    for (const LiveLife& twin : twins_)
      add(AgentFaultKind::twin, twin.born_ns, std::max<TimeNs>(twin.last_ns - twin.born_ns, 1));
    if (lives_.empty()) {
      add(AgentFaultKind::crash, 0, {});  // before it has said anything
      return false;
    }
    add(AgentFaultKind::late, 0, std::max<TimeNs>(lives_.front().born_ns, 1));
    for (std::size_t n = 0; n < lives_.size(); ++n) {
      const auto next_ns =
          n + 1 < lives_.size() ? std::optional(lives_[n + 1].born_ns) : std::optional<TimeNs>();
      const auto died_ns = death_ns(lives_[n], next_ns);
      add_pauses(lives_[n], died_ns.value_or(INT64_MAX));
      add_malformed(lives_[n], died_ns.value_or(INT64_MAX));
      if (died_ns)
        add(AgentFaultKind::crash, *died_ns,
            next_ns ? std::optional(std::max<TimeNs>(*next_ns - *died_ns, 1)) : std::nullopt);
      if (!next_ns) return !died_ns;
    }
    return true;
  }

 private:
  AgentFault& add(AgentFaultKind kind, TimeNs at_ns, std::optional<TimeNs> for_ns) {
    AgentFault fault;
    fault.agent = agent_;
    fault.kind = kind;
    fault.at_ns = at_ns;
    fault.for_ns = for_ns;
    return out_.emplace_back(fault);
  }

  /// The first time within [from_ns, to_ns) that this was done to the agent's process.
  std::optional<TimeNs> first(const std::string& action, TimeNs from_ns, TimeNs to_ns) const {
    for (const LiveAct& act : run_.acts)
      if (act.agent == agent_ && act.action == action && act.at_ns >= from_ns && act.at_ns < to_ns)
        return act.at_ns;
    return std::nullopt;
  }

  /// Whoever was paused for good was silent from then on: for the others that is a death. A silence
  /// shorter than the lease before the run's end is none, for nobody could notice it.
  std::optional<TimeNs> death_ns(const LiveLife& life, std::optional<TimeNs> next_ns) const {
    const TimeNs until_ns = next_ns.value_or(INT64_MAX);
    for (const LiveAct& act : run_.acts)
      if (act.agent == agent_ && act.action == "pause" && act.at_ns >= life.born_ns &&
          act.at_ns < until_ns && !first("resume", act.at_ns, until_ns))
        return act.at_ns;
    if (const auto killed_ns = first("kill", life.born_ns, until_ns)) return killed_ns;
    if (next_ns || life.ended_by == "fault") return std::min(life.last_ns, until_ns);
    const bool was_missed = end_ns(run_) - life.last_ns > run_.mission.auction.lease_ns;
    if (life.ended_by != "coordinator" && was_missed) return life.last_ns;
    return std::nullopt;
  }

  void add_pauses(const LiveLife& life, TimeNs died_ns) {
    for (const LiveAct& act : run_.acts) {
      if (act.agent != agent_ || act.action != "pause") continue;
      if (act.at_ns < life.born_ns || act.at_ns >= died_ns) continue;
      add(AgentFaultKind::pause, act.at_ns,
          first("resume", act.at_ns, died_ns).value_or(died_ns) - act.at_ns);
    }
  }

  void add_malformed(const LiveLife& life, TimeNs died_ns) {
    for (AgentFault fault : run_.schedule.agents) {
      if (fault.agent != agent_ || fault.kind != AgentFaultKind::malformed) continue;
      const bool over_bid = fault.malformation == Malformation::over_bid;
      if (over_bid && life.ended_by != "fault") continue;
      fault.at_ns = over_bid ? died_ns : std::max(fault.at_ns, life.born_ns);
      if (fault.at_ns <= died_ns) out_.push_back(fault);
    }
  }

  const LiveRun& run_;
  AgentId agent_;
  std::vector<AgentFault>& out_;
  std::vector<LiveLife> lives_, twins_;
};

}  // namespace

FaultSchedule faults_of(const LiveRun& run) {
  FaultSchedule out = run.schedule;
  if (run.is_world) return out;
  if (!out.until_ns && !(out.links.empty() && out.partitions.empty())) out.until_ns = end_ns(run);
  std::erase_if(out.agents,
                [](const AgentFault& fault) { return fault.kind != AgentFaultKind::clock; });
  bool somebody_lives = false;
  for (const Uav& uav : run.mission.fleet)
    if (History(run, uav.id, out.agents).write()) somebody_lives = true;
  if (!somebody_lives)
    throw InputError("nobody was alive at the end of this run: there is nothing to agree on");
  return out;
}

}  // namespace arcbid
