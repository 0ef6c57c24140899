// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/world/world_log.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.hpp"
#include "core/io/faults/fault_files.hpp"
#include "core/io/run/run_files.hpp"
#include "core/route/make_transit.hpp"
#include "core/route/share.hpp"
#include "sim/launcher/fault_script.hpp"

namespace arcbid {

struct WorldLog::Life {
  AgentId agent;
  std::unique_ptr<AgentLog> log;
  std::optional<Agreement> agreement;  // until its route is published
};

/// What was done to processes, as a launcher writes it down.
nlohmann::json WorldLog::acts_until(TimeNs end_ns) const {
  nlohmann::json out = nlohmann::json::array();
  FaultScript script(spec_.faults);
  for (ProcessFault fault; script.next(end_ns, fault);)
    out.push_back({{"time_s", static_cast<double>(fault.at_ns) * 1e-9},
                   {"agent", fault.agent.value},
                   {"action", name_of(fault.action)},
                   {"fault", in_words(fault)}});
  return out;
}

WorldLog::WorldLog(const WorldSpec& spec, std::filesystem::path directory)
    : spec_(spec),
      transit_(spec.transit ? spec.transit : make_transit(spec.mission)),
      directory_(std::move(directory)) {
  std::error_code none;
  if (std::filesystem::exists(directory_, none) && !std::filesystem::is_empty(directory_, none))
    throw InputError(
        fmt::format("{}: is not empty; name a new directory with --record", directory_.string()));
  write_arcs_file(directory_, spec.mission);
  write_whole(directory_ / "faults.yaml", to_yaml(spec.faults));
}

WorldLog::~WorldLog() = default;

void WorldLog::born(std::uint32_t life, AgentId agent, std::uint64_t incarnation, TimeNs now_ns,
                    TimeNs clock_ns) {
  const auto file =
      directory_ / "logs" / fmt::format("agent_{}.{}.{}.sqlite", agent.value, incarnation, life);
  const auto refuse = [](const std::string& why) { throw RunError(why); };
  auto log =
      std::make_unique<AgentLog>(file, AgentLog::Life{agent, incarnation, spec_.seed}, refuse);
  log->birth(now_ns, {agent, incarnation, clock_ns}, spec_.mission);
  lives_[life] = std::make_unique<Life>(Life{agent, std::move(log), std::nullopt});
}

void WorldLog::stepped(std::uint32_t number, TimeNs now_ns, const Event& event,
                       const Update& update) {
  Life& life = *lives_.at(number);
  if (std::holds_alternative<RoutePublished>(event.what)) plan(life, now_ns);
  life.log->step(now_ns, {event, update});
  life.log->commit_if_due(now_ns);
  if (update.agreement_lost) life.agreement.reset();
  if (update.agreed) life.agreement = update.agreed;
}

void WorldLog::met_fate(std::uint32_t life, TimeNs now_ns, const Header& header, const Fate& fate) {
  lives_.at(life)->log->fate(now_ns, header, fate.arrivals_ns);
}

/// A world may end with the last proof, before the last routes are published in it.
void WorldLog::outlived(std::uint32_t number, TimeNs now_ns) {
  Life& life = *lives_.at(number);
  plan(life, now_ns);
  life.log->write(now_ns, log_kind::end, {{"by", "world"}});
}

/// In the world a route is published at once; on record it stands as it would be flown.
void WorldLog::plan(Life& life, TimeNs now_ns) const {
  if (!life.agreement) return;
  const Mission& mission = spec_.mission;
  const auto uav = std::find_if(mission.fleet.begin(), mission.fleet.end(),
                                [&life](const Uav& u) { return u.id == life.agent; });
  const TaskSet tasks = split(mission.arcs, mission.auction.split_m, mission.auction.max_tasks);
  const Agreement agreement = *std::exchange(life.agreement, std::nullopt);
  const Share share = share_of(mission, tasks, agreement, life.agent, *transit_);
  const Route route = plan_route(mission, tasks, share.path, *uav, *transit_);
  life.log->route(now_ns, {agreement.view_hash, route});
  write_route_file(directory_, life.agent, mission, tasks, agreement, share.owners, route,
                   static_cast<double>(now_ns) * 1e-9);
}

void WorldLog::write_result(const WorldResult& result) {
  for (auto& [number, life] : lives_) life->log->commit();
  const nlohmann::json out{
      {"schema", 1},
      {"world",
       {{"seed", result.seed}, {"latency_ns", {spec_.latency_ns.least, spec_.latency_ns.most}}}},
      {"agreement",
       {{"reached", result.agreed},
        {"rounds", result.rounds},
        {"time_s", static_cast<double>(result.agreed_ns) * 1e-9}}},
      {"makespan_s", result.makespan_s},
      {"messages", {{"sent", result.messages}, {"bytes", result.bytes}}},
      {"faults", acts_until(result.agreed_ns)}};
  write_whole(directory_ / "result.json", out.dump(2) + "\n");
}

}  // namespace arcbid
