// SPDX-License-Identifier: GPL-3.0-or-later
#include "agent/hosted_agent.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <utility>

#include "agent/shared_transit.hpp"
#include "core/io/run/arcs_json.hpp"
#include "core/io/run/run_files.hpp"
#include "core/route/make_transit.hpp"
#include "idl/payload_size.hpp"

namespace arcbid {
namespace {

using nlohmann::json;

constexpr int surely_alive = 2;  // messages; one may have been under way when its sender died
constexpr TimeNs ask_interval_ns = 200'000'000;
constexpr TimeNs traffic_interval_ns = 500'000'000;
constexpr TimeNs round_interval_ns = 100'000'000;

double seconds(TimeNs ns) {
  return static_cast<double>(ns) * 1e-9;
}

json count(const std::vector<AgentId>& agents) {
  json out = json::array();
  for (const AgentId agent : agents) out.push_back(agent.value);
  return out;
}

}  // namespace

HostedAgent::HostedAgent(AgentOptions options, SharedBus& bus)
    : options_(std::move(options)),
      bus_(bus),
      report_(fmt::format("agent {}", options_.id.value), options_.json_events, options_.id),
      incarnation_(birth_stamp_ms()),
      log_(log_file(), {options_.id, incarnation_, 0},
           [this](const std::string& why) {
             report_("warning", {{"text", why}});
           }),
      planner_([this] { bus_.wake(); }) {
  report_("up", {{"pid", getpid()}});
}

/// A life has its own log: an agent that comes back must not write over what its last life left.
std::optional<std::filesystem::path> HostedAgent::log_file() const {
  if (!options_.run) return std::nullopt;
  return *options_.run / "logs" /
         fmt::format("agent_{}.{}.sqlite", options_.id.value, incarnation_);
}

void HostedAgent::turn() {
  for (const Received& received : bus_.take(options_.id)) {
    std::visit([this](const auto& message) { handle(message); }, received);
    if (done_) return;
  }
  hear_what_is_due();
  if (clock_ns() >= wake_ns_) {
    if (agent_)
      step({clock_ns(), Tick{bus_.matched_agents()}});
    else
      ask_for_mission();
  }
  say_what_is_malformed();
  fly_if_planned();
  log_.commit_if_due(now_ns());
  report_traffic(false);
}

void HostedAgent::finish() {
  report_traffic(true);
  log_.write(now_ns(), "end", {{"by", ended_by_}});
}

TimeNs HostedAgent::clock_ns() const {
  return options_.faults ? clock_of(*options_.faults, options_.id, now_ns()) : now_ns();
}

TimeNs HostedAgent::wait_ns() const {
  TimeNs wait = wake_ns_ - clock_ns();
  if (links_ && links_->next_ns()) wait = std::min(wait, *links_->next_ns() - now_ns());
  if (malformer_ && malformer_->next_ns()) wait = std::min(wait, *malformer_->next_ns() - now_ns());
  if (log_.due_ns()) wait = std::min(wait, *log_.due_ns() - now_ns());
  return std::max<TimeNs>(wait, 0);
}

void HostedAgent::hear_what_is_due() {
  if (!links_) return;
  for (const AgentMessage& message : links_->due(now_ns()))
    std::visit([this](const auto& m) { step({clock_ns(), m}); }, message);
}

/// What the fault schedule makes this agent say. The auction knows nothing of it.
void HostedAgent::say_what_is_malformed() {
  if (!malformer_) return;
  const Malformer::Speech speech = malformer_->due(now_ns());
  for (const auto& [how, message] : speech.messages) {
    log_.write(now_ns(), "sent_malformed", {{"what", name_of(how)}, {"message", to_json(message)}});
    bus_.publish(options_.id, message);
  }
  if (!speech.ends) return;
  report_("warning", {{"text", fmt::format("agent {} bids far above everybody for every task and "
                                           "ends: fault over_bid",
                                           options_.id.value)}});
  ended_by_ = "fault";
  done_ = Exit::check_failed;
}

/// Until the mission is here, status messages say so, and the coordinator sends it again.
void HostedAgent::ask_for_mission() {
  StatusMessage status;
  status.header = {options_.id, incarnation_, ++sequence_, 0, 0};
  status.matched_peers = bus_.matched_agents();
  bus_.publish(options_.id, status);
  wake_ns_ = clock_ns() + ask_interval_ns;
}

void HostedAgent::handle(const Mission& mission) {
  if (agent_) {
    if (digest(mission) != mission_digest_)
      refuse(
          fmt::format("mission {} came while {} is under way", hex(mission.id), hex(mission_->id)));
    return;
  }
  const auto me = std::find_if(mission.fleet.begin(), mission.fleet.end(),
                               [this](const Uav& uav) { return uav.id == options_.id; });
  if (me == mission.fleet.end()) {
    refuse(fmt::format("mission {} has no agent {}", hex(mission.id), options_.id.value));
    return;
  }
  mission_ = std::make_shared<const Mission>(mission);
  mission_digest_ = digest(mission);
  transit_ = options_.run ? shared_transit(mission, *options_.run) : make_transit(mission);
  const Birth birth{options_.id, incarnation_, clock_ns()};
  agent_ = std::make_unique<Agent>(options_.id, incarnation_, mission_, transit_, birth.now_ns);
  log_.birth(now_ns(), birth, mission);
  install_faults();
  report_("mission", {{"arcs", mission.arcs.size()}, {"tasks", agent_->tasks().tasks.size()}});
  for (const std::string& warning : agent_->tasks().warnings)
    report_("warning", {{"text", warning}});
  step({clock_ns(), Tick{bus_.matched_agents()}});
}

/// Where the agents are is only known with the mission.
void HostedAgent::install_faults() {
  if (!options_.faults) return;
  malformer_.emplace(*options_.faults, options_.id, agent_->tasks().tasks.size(),
                     mission_->auction.tick_ns);
  if (options_.fault_tier == FaultTier::packets)
    bus_.set_packet_faults(*options_.faults, mission_->fleet, options_.epoch_ns);
  else
    links_.emplace(*options_.faults, mission_->fleet, options_.id);
}

void HostedAgent::handle(const ControlMessage& control) {
  if (!mission_ || control.mission_digest != mission_digest_) return;  // another mission's
  log_.write(now_ns(), "control",
             {{"command", static_cast<int>(control.command)}, {"reason", control.reason}});
  ended_by_ = "coordinator";
  done_ = control.command == Command::complete ? Exit::done : Exit::check_failed;
}

void HostedAgent::handle(const Malformed& malformed) {
  const std::string reason = fmt::format("{}: {}", malformed.topic, malformed.reason);
  log_.write(now_ns(), "refused", {{"reason", reason}});  // the bus has counted it
  report_("refused", {{"reason", reason}});
}

template <class Message>
void HostedAgent::handle(const Message& message) {
  if (message.header.sender == options_.id) meet_namesake(message.header);
  if (links_) {
    const TimeNs came_ns = now_ns();
    log_.fate(came_ns, message.header, links_->arrived(message, payload_size(message), came_ns));
  } else if (agent_) {
    step({clock_ns(), message});
  }
}

/// Somebody else speaks as this agent. The dead send nothing, so it lives. Incarnations do not tell
/// who came first, for each is refuted by the other; but whoever has said more is the elder, and
/// this process must go before it confuses the fleet further.
void HostedAgent::meet_namesake(const Header& header) {
  if (header.sequence <= bus_.counters(options_.id).sent || ++elder_messages_ < surely_alive)
    return;
  throw InputError(fmt::format(
      "--id {}: taken: a process that started earlier flies as agent {}; choose another id",
      options_.id.value, options_.id.value));
}

void HostedAgent::refuse(const std::string& reason) {
  ++refused_;
  log_.write(now_ns(), "refused", {{"reason", reason}});
  report_("refused", {{"reason", reason}});
}

void HostedAgent::step(Event event) {
  Step step{std::move(event), {}};
  step.update = agent_->step(step.event);
  log_.step(now_ns(), step);
  if (step.update.agreed) agreed_s_ = seconds(now_ns());
  const bool winners_changed = step.update.decision || !step.update.died.empty();
  carry_out(step.update);
  if (winners_changed) winners_ = agent_->winners();
}

void HostedAgent::carry_out(Update& update) {
  wake_ns_ = update.wake_ns;
  for (const auto& bid : update.bids) {
    bus_.publish(options_.id, bid);
    if (malformer_) malformer_->said(bid);
  }
  for (const auto& relay : update.relays) bus_.publish(options_.id, relay);
  for (const auto& status : update.statuses) bus_.publish(options_.id, status);
  if (update.refused) refuse(*update.refused);
  report(update);
  if (update.agreement_lost) {
    to_plan_.reset();
    planner_.drop();
  }
  if (update.agreed) {
    to_plan_ = std::move(update.agreed);
    start_planning();
  }
}

void HostedAgent::report(const Update& update) {
  if (update.started) report_("started", {{"time_s", seconds(now_ns())}});
  if (!update.died.empty()) {
    report_("died", {{"agents", count(update.died)}});
    release(update.died);
  }
  if (!update.returned.empty()) report_("returned", {{"agents", count(update.returned)}});
  if (update.agreement_lost) report_("reopened", json::object());
  if (update.decision && update.decision->changed) report_round(*update.decision);
  if (update.agreed)
    report_("agreed", {{"view_hash", hex(update.agreed->view_hash)},
                       {"round", update.agreed->round},
                       {"time_s", agreed_s_},
                       {"members", count(update.agreed->members)},
                       {"no_bidders", no_bidders_json(update.agreed->left)}});
}

/// For whoever watches: no faster than it can be read, for rounds take a few milliseconds.
void HostedAgent::report_round(const DecisionMade& decision) {
  if (now_ns() - round_reported_ns_ < round_interval_ns) return;
  round_reported_ns_ = now_ns();
  report_("round", {{"round", decision.round}, {"tasks", decision.path.size()}});
}

/// The dead win nothing any more: what they had won last is free again, and said to be so.
void HostedAgent::release(const std::vector<AgentId>& dead) {
  for (const AgentId agent : dead) {
    json tasks = json::array();
    for (std::uint32_t j = 0; j < winners_.size(); ++j)
      if (winners_[j].winner == agent) tasks.push_back(j);
    const json fields{{"agent", agent.value}, {"tasks", tasks}};
    log_.write(now_ns(), "released", fields);
    report_("released", fields);
  }
}

void HostedAgent::start_planning() {
  if (!to_plan_ || planner_.busy()) return;  // the next one starts when this is done
  planner_.plan(mission_, transit_, agent_->tasks(), *to_plan_, options_.id);
}

void HostedAgent::fly_if_planned() {
  const std::optional<PlannedFlight> flight = planner_.take();
  if (!flight) return;
  if (!to_plan_ || to_plan_->view_hash != flight->view_hash) return start_planning();  // outdated
  publish(*std::exchange(to_plan_, std::nullopt), *flight);
}

/// What this agent gives away of what it won, and what it gets.
void HostedAgent::tell_exchanges(const Agreement& agreement, const Share& share) {
  if (mission_->auction.trades == TradesKind::off) return;
  json given = json::array(), taken = json::array();
  for (std::uint32_t j = 0; j < share.owners.size(); ++j) {
    const bool won = agreement.winners[j].winner == options_.id;
    const bool flies = share.owners[j] == options_.id;
    if (won && !flies) given.push_back(j);
    if (flies && !won) taken.push_back(j);
  }
  const json fields{{"view_hash", hex(agreement.view_hash)},
                    {"exchanges", share.exchanges},
                    {"given", given},
                    {"taken", taken}};
  log_.write(now_ns(), "exchanged", fields);
  report_("exchanged", fields);
}

/// Says what is flown and how: on disk, to all, and only then to the auction.
void HostedAgent::publish(const Agreement& agreement, const PlannedFlight& flight) {
  const auto& [view_hash, share, route] = flight;
  tell_exchanges(agreement, share);
  if (options_.run) {
    try {
      write_route_file(*options_.run, options_.id, *mission_, agent_->tasks(), agreement,
                       share.owners, route, agreed_s_);
    } catch (const std::runtime_error& error) {
      report_("warning", {{"text", error.what()}});
    }
  }
  RouteMessage message;
  message.header = {options_.id, incarnation_, ++sequence_, mission_digest_,
                    agent_->tasks().digest};
  message.view_hash = view_hash;
  message.owners_digest = digest(share.owners);
  message.length_m = route.length_m;
  message.time_s = route.time_s;
  message.legs = route.legs;
  log_.route(now_ns(), {view_hash, route});
  log_.commit();
  bus_.publish(options_.id, message);
  report_("routed", {{"view_hash", hex(view_hash)}, {"members", count(agreement.members)}});
  step({clock_ns(), RoutePublished{view_hash}});
}

void HostedAgent::report_traffic(bool last) {
  if (!last && now_ns() - traffic_reported_ns_ < traffic_interval_ns) return;
  traffic_reported_ns_ = now_ns();
  const TrafficCounters traffic = bus_.counters(options_.id);
  const json fields{{"sent", traffic.sent},
                    {"received", traffic.received},
                    {"dropped", traffic.dropped + refused_},
                    {"bytes", traffic.bytes_sent}};
  if (last) log_.write(now_ns(), "traffic", fields);
  report_("traffic", fields);
  report_links(last);
}

void HostedAgent::report_links(bool last) {
  const auto counters = links_ ? links_->counters() : bus_.packet_counters();
  if (counters.empty()) return;
  json from = json::array();
  for (const auto& [sender, c] : counters)
    from.push_back({{"from", sender.value},
                    {"sent", c.sent},
                    {"dropped", c.dropped},
                    {"delayed", c.delayed},
                    {"duplicated", c.duplicated},
                    {"bytes", c.bytes}});
  if (last) log_.write(now_ns(), "links", from);
  report_("links", {{"links", from}});
}

}  // namespace arcbid
