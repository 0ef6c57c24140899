// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/replay/verify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/auction/agent.hpp"
#include "core/route/make_transit.hpp"
#include "core/route/route.hpp"
#include "core/route/share.hpp"

namespace arcbid {
namespace {

using nlohmann::json;

struct Difference {
  std::string field;  // as a path: "decision.claims.bundle.3.bid"
  json log, replay;
};

/// The first leaf that differs, in the order of the fields.
std::optional<Difference> first_difference(const json& log, const json& replay,
                                           const std::string& field) {
  const auto inside = [&field](const std::string& part) {
    return field.empty() ? part : fmt::format("{}.{}", field, part);
  };
  if (log.is_object() && replay.is_object()) {
    for (const auto& [key, value] : log.items())
      if (const auto found = first_difference(value, replay.value(key, json()), inside(key)))
        return found;
    return std::nullopt;
  }
  if (log.is_array() && replay.is_array()) {
    for (std::size_t n = 0; n < std::max(log.size(), replay.size()); ++n) {
      const json a = n < log.size() ? log[n] : json(), b = n < replay.size() ? replay[n] : json();
      if (const auto found = first_difference(a, b, inside(std::to_string(n)))) return found;
    }
    return std::nullopt;
  }
  if (log == replay) return std::nullopt;
  return Difference{field, log, replay};
}

/// The task that a difference is about: a claim's or a stop's own, or the place in a table.
std::optional<TaskId> task_of(const Difference& difference, const json& update) {
  const std::string& field = difference.field;
  for (const char* list : {"bundle.", "path.", "beliefs.", "winners."}) {
    const auto at = field.find(list);
    if (at == std::string::npos) continue;
    const auto from = at + std::string_view(list).size();
    const auto n = static_cast<std::uint32_t>(std::stoul(field.substr(from)));
    if (list[0] == 'b' && list[1] == 'e') return TaskId{n};
    if (list[0] == 'w') return TaskId{n};
    std::string pointer = fmt::format("/{}{}/task", field.substr(0, from), n);
    std::replace(pointer.begin(), pointer.end(), '.', '/');
    const json::json_pointer place(pointer);
    if (update.contains(place)) return TaskId{update.at(place).get<std::uint32_t>()};
  }
  return std::nullopt;
}

Divergence divergence_of(const LifeLog& life, const Mark& mark, const TaskSet& tasks,
                         const Update& logged, const Update& replayed) {
  Divergence out{life.agent(), mark.seq, mark.t_ns, mark.round, std::nullopt, {}};
  const json log = to_json(logged), replay = to_json(replayed);
  const auto found = first_difference(log, replay, "");
  if (!found) {
    out.what = "the same values, other bytes: the record was written differently";
    return out;
  }
  auto task = task_of(*found, log);
  if (!task) task = task_of(*found, replay);
  if (task && task->value < tasks.tasks.size()) out.arc = tasks.tasks[task->value].arc;
  out.what = fmt::format("{}{}: the log has {}, the replay {}", found->field,
                         task ? fmt::format(" (task {})", task->value) : "", found->log.dump(),
                         found->replay.dump());
  return out;
}

/// Exchanges and tours: functions of the mission and of what was agreed on.
class RouteVerifier {
 public:
  RouteVerifier(const LifeLog& life, const TaskSet& tasks, const Transit& transit)
      : life_(life), tasks_(tasks), transit_(transit) {}

  void agreed(const Mark& mark, const Agreement& agreement) {
    agreements_[agreement.view_hash] = {mark, agreement};
  }
  void verify(LifeVerdict& verdict) const {
    const Mission& mission = *life_.mission();
    const auto uav = std::find_if(mission.fleet.begin(), mission.fleet.end(),
                                  [this](const Uav& u) { return u.id == life_.agent(); });
    for (const PlannedRoute& logged : life_.routes()) {
      const auto won = agreements_.find(logged.view_hash);
      if (won == agreements_.end()) continue;
      const auto& [mark, agreement] = won->second;
      const Share share = share_of(mission, tasks_, agreement, life_.agent(), transit_);
      const PlannedRoute again{logged.view_hash,
                               plan_route(mission, tasks_, share.path, *uav, transit_)};
      if (encode(again) == encode(logged)) {
        ++verdict.routes;
        continue;
      }
      verdict.divergence =
          Divergence{life_.agent(),
                     mark.seq,
                     mark.t_ns,
                     mark.round,
                     std::nullopt,
                     fmt::format("route of agreement {:016x}: the log has {} m in {} legs, the "
                                 "replay {} m in {}",
                                 logged.view_hash, logged.route.length_m, logged.route.legs.size(),
                                 again.route.length_m, again.route.legs.size())};
      return;
    }
  }

 private:
  const LifeLog& life_;
  const TaskSet& tasks_;
  const Transit& transit_;
  std::map<std::uint64_t, std::pair<Mark, Agreement>> agreements_;
};

}  // namespace

LifeVerdict verify(const LifeLog& life) {
  life.schemas().demand_own();
  LifeVerdict verdict;
  const auto transit = make_transit(*life.mission());
  Agent agent(life.birth()->agent, life.birth()->incarnation, life.mission(), transit,
              life.birth()->now_ns);
  RouteVerifier routes(life, agent.tasks(), *transit);
  const std::size_t whole = life.gap().value_or(life.marks().size());
  verdict.beyond_proof = life.marks().size() - whole;
  life.steps([&](std::size_t at, Step logged, std::string_view bytes) {
    if (at >= whole) return false;
    Step replayed{std::move(logged.event), {}};
    replayed.update = agent.step(replayed.event);
    if (encode(replayed) != bytes) {
      verdict.divergence =
          divergence_of(life, life.marks()[at], agent.tasks(), logged.update, replayed.update);
      return false;
    }
    if (replayed.update.agreed) routes.agreed(life.marks()[at], *replayed.update.agreed);
    ++verdict.steps;
    return true;
  });
  if (!verdict.divergence) routes.verify(verdict);
  return verdict;
}

std::string describe(const Divergence& d) {
  return fmt::format("agent {}, round {}{}, record {} at {:.6f} s: {}", d.agent.value, d.round,
                     d.arc ? fmt::format(", arc {}", d.arc->value) : "", d.record,
                     static_cast<double>(d.t_ns) * 1e-9, d.what);
}

}  // namespace arcbid
