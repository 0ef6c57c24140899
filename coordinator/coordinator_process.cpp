// SPDX-License-Identifier: GPL-3.0-or-later
#include "coordinator/coordinator_process.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <utility>

#include "core/base/digest.hpp"
#include "core/io/build/build.hpp"
#include "core/io/mission/mission_plan.hpp"
#include "core/io/run/agent_log.hpp"
#include "core/io/run/arcs_json.hpp"
#include "core/io/run/run_files.hpp"

namespace arcbid {
namespace {

using nlohmann::json;
using namespace std::chrono_literals;

constexpr TimeNs repeat_interval_ns = 1'000'000'000;
constexpr TimeNs alone_ns = 3'000'000'000;
constexpr TimeNs farewell_ns = 2'000'000'000;  // for the last message to reach everybody

}  // namespace

CoordinatorProcess::CoordinatorProcess(CoordinatorOptions options)
    : options_(std::move(options)),
      report_("coordinator", options_.json_events),
      bus_(options_.config.network, options_.domain, the_coordinator, fleet_size(options_.config)) {
  if (options_.run) {
    log_.emplace(*options_.run / "logs" / fmt::format("coordinator.{}.sqlite", birth_stamp_ms()));
    log_->meta("schema", RunLog::schema);
    log_->meta("process", {{"role", "coordinator"}, {"pid", getpid()}});
    log_->meta("build", {{"version", build_version()}, {"commit", build_commit()}});
    log_->meta("config", to_yaml(options_.config));
    heard_status_ = log_->kind(cdr_kind<StatusMessage>(log_kind::heard_status));
    log_->commit();
  }
  report_("up", {{"pid", getpid()}, {"domain", options_.domain}});
}

Exit CoordinatorProcess::run() {
  publish_mission();
  // Planning takes what it takes: it does not depend on anybody else.
  const TimeNs deadline_ns = now_ns() + static_cast<TimeNs>(options_.config.timeout_s * 1e9);
  while (!stop_requested()) {
    for (const Received& received : bus_.wait(50ms))
      std::visit([this](const auto& message) { handle(message); }, received);
    publish_again_if_wanted();
    warn_if_alone();
    if (log_) log_->commit_if_due(now_ns());
    if (const auto exit = ended(deadline_ns)) return *exit;
  }
  report_traffic();
  return Exit::done;
}

/// Says the end to all when there is a reason for it.
std::optional<Exit> CoordinatorProcess::ended(TimeNs deadline_ns) {
  if (const auto discord = progress_->discord()) {
    const std::string reason = fmt::format(
        "agents {} and {} agreed, but worked out different exchanges: their arithmetic differs; "
        "use the same build on the same kind of processor, or 'auction.trades: off'",
        discord->first.value, discord->second.value);
    report_("warning", {{"text", reason}});
    end_mission(Command::abort, reason);
    return Exit::check_failed;
  }
  const auto hash = progress_->complete(now_ns());
  if (hash && now_ns() >= options_.not_before_ns) {
    report_("complete", {{"view_hash", hex(*hash)}});
    end_mission(Command::complete, "every living agent has published its route");
    return Exit::done;
  }
  if (now_ns() <= deadline_ns) return std::nullopt;
  report_("timeout", {{"timeout_s", options_.config.timeout_s}});
  end_mission(Command::abort, "the mission took longer than timeout_s");
  return Exit::check_failed;
}

/// A coordinator that comes back publishes the mission of its last life: the plan follows from the
/// config and the id, bit for bit.
std::uint64_t CoordinatorProcess::mission_id() const {
  const auto fresh = Digest().add(birth_stamp_ms()).add(std::uint64_t(getpid())).value();
  if (!options_.run) return fresh;
  const auto file = *options_.run / "mission_id";
  if (std::ifstream in(file); in) {
    std::uint64_t id = 0;
    if (!(in >> std::hex >> id))
      throw InputError(fmt::format("{}: is not a mission's id in hexadecimal", file.string()));
    return id;
  }
  write_whole(file, hex(fresh) + "\n");
  return fresh;
}

void CoordinatorProcess::publish_mission() {
  MissionPlan plan = plan_mission(options_.config, mission_id());
  mission_ = std::move(plan.mission);
  mission_digest_ = digest(mission_);
  progress_.emplace(mission_);
  for (const std::string& warning : plan.warnings) report_("warning", {{"text", warning}});
  if (options_.run) {
    write_arcs_file(*options_.run, mission_);
    write_structure_file(*options_.run, plan.shown);
  }
  if (log_) {
    log_->append(now_ns(), log_->kind(cdr_kind<Mission>(log_kind::mission)), encode(mission_));
    log_->commit();
  }
  double total_m = 0;
  for (const Arc& arc : mission_.arcs) total_m += length_m(arc.waypoints);
  bus_.publish(mission_);
  published_ns_ = now_ns();
  report_("published", {{"arcs", mission_.arcs.size()},
                        {"metres", total_m},
                        {"time_s", static_cast<double>(published_ns_) * 1e-9}});
}

void CoordinatorProcess::publish_again_if_wanted() {
  if (!progress_->mission_wanted() || now_ns() - published_ns_ < repeat_interval_ns) return;
  bus_.publish(mission_);
  progress_->mission_sent();
  published_ns_ = now_ns();
}

/// Silence has a cause that a person can mend: say which, once.
void CoordinatorProcess::warn_if_alone() {
  if (warned_alone_ || now_ns() - published_ns_ < alone_ns || bus_.matched_agents() > 0) return;
  warned_alone_ = true;
  const NetworkConfig& network = options_.config.network;
  report_("warning",
          {{"text", network.transport == TransportKind::discovery_server
                        ? fmt::format("no agent found yet: is a discovery server running at {}:{}?",
                                      network.server_address, network.server_port)
                        : fmt::format("no agent found yet on {} in domain {}",
                                      network.interface_address, options_.domain)}});
}

void CoordinatorProcess::handle(const StatusMessage& status) {
  const bool of_this_mission = status.header.mission_digest == mission_digest_;
  if (!of_this_mission && status.phase != Phase::waiting_for_mission) return;
  progress_->heard(status, now_ns());
  if (log_) log_->append(now_ns(), heard_status_, encode(status));
}

void CoordinatorProcess::handle(const RouteMessage& route) {
  if (route.header.mission_digest != mission_digest_) return;
  progress_->heard(route);
  if (log_)
    log_->append(now_ns(), "heard_route",
                 {{"agent", route.header.sender.value},
                  {"view_hash", hex(route.view_hash)},
                  {"owners_digest", hex(route.owners_digest)},
                  {"length_m", route.length_m},
                  {"time_s", route.time_s}});
}

void CoordinatorProcess::handle(const Malformed& malformed) {
  if (log_) log_->append(now_ns(), "refused", {{"reason", malformed.reason}});
  report_("refused", {{"reason", fmt::format("{}: {}", malformed.topic, malformed.reason)}});
}

void CoordinatorProcess::end_mission(Command command, const std::string& reason) {
  if (log_) {
    log_->append(now_ns(), "sent_control",
                 {{"command", static_cast<int>(command)}, {"reason", reason}});
    log_->commit();
  }
  bus_.publish(ControlMessage{mission_digest_, command, reason});
  const TimeNs farewell = now_ns() + farewell_ns;
  while (bus_.matched_agents() > 0 && now_ns() < farewell && !stop_requested()) bus_.wait(20ms);
  if (log_) log_->append(now_ns(), "end", {{"reason", reason}});
  report_traffic();
}

void CoordinatorProcess::report_traffic() {
  const TrafficCounters traffic = bus_.counters();
  report_("traffic", {{"sent", traffic.sent},
                      {"received", traffic.received},
                      {"dropped", traffic.dropped},
                      {"bytes", traffic.bytes_sent}});
}

}  // namespace arcbid
