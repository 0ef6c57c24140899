// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/airspace/runs.hpp"
#include "idl/convert_common.hpp"

namespace arcbid {

std::vector<wire::Waypoint> convert::encode(const std::vector<Waypoint>& waypoints) {
  std::vector<wire::Waypoint> out(waypoints.size());
  for (std::size_t i = 0; i < waypoints.size(); ++i) {
    out[i].position_m(encode(waypoints[i].position_m));
    out[i].look(encode(waypoints[i].look));
  }
  return out;
}

std::vector<Waypoint> convert::decode(const std::vector<wire::Waypoint>& waypoints,
                                      Verdict& verdict) {
  std::vector<Waypoint> out;
  out.reserve(waypoints.size());
  for (const wire::Waypoint& w : waypoints)
    out.push_back({decode(w.position_m(), "waypoint.position_m", verdict),
                   decode(w.look(), "waypoint.look", verdict)});
  return out;
}

namespace {

using convert::decode;
using convert::encode;
using convert::enumerator;
using convert::Verdict;

wire::AuctionSettings encode(const AuctionSettings& settings) {
  wire::AuctionSettings out;
  out.policy(static_cast<wire::PolicyKind>(settings.policy));
  out.score(static_cast<wire::ScoreKind>(settings.score));
  out.discount_per_s(settings.discount_per_s);
  out.has_split(settings.split_m.has_value());
  out.split_m(settings.split_m.value_or(0));
  out.max_tasks(settings.max_tasks);
  out.bundle_limit(settings.bundle_limit);
  out.trades(static_cast<wire::TradesKind>(settings.trades));
  out.audit_bids(settings.audit_bids);
  out.tick_ns(settings.tick_ns);
  out.lease_ns(settings.lease_ns);
  out.barrier_ns(settings.barrier_ns);
  return out;
}

AuctionSettings decode(const wire::AuctionSettings& settings, Verdict& verdict) {
  AuctionSettings out;
  out.policy =
      enumerator<PolicyKind>(settings.policy(), wire::POLICY_ACBBA, "auction.policy", verdict);
  out.score = enumerator<ScoreKind>(settings.score(), wire::SCORE_MINIMAX_LONG_FIRST,
                                    "auction.score", verdict);
  out.discount_per_s = settings.discount_per_s();
  verdict.require(std::isfinite(out.discount_per_s) && out.discount_per_s > 0,
                  "auction.discount_per_s", out.discount_per_s);
  verdict.finite("auction.split_m", settings.split_m());
  if (settings.has_split()) {
    out.split_m = settings.split_m();
    verdict.require(*out.split_m > 0, "auction.split_m", *out.split_m);
  }
  out.max_tasks = settings.max_tasks();
  verdict.require(out.max_tasks > 0, "auction.max_tasks", out.max_tasks);
  out.bundle_limit = settings.bundle_limit();
  out.trades =
      enumerator<TradesKind>(settings.trades(), wire::TRADES_FULL, "auction.trades", verdict);
  out.audit_bids = settings.audit_bids();
  out.tick_ns = settings.tick_ns();
  verdict.require(out.tick_ns > 0, "auction.tick_ns", out.tick_ns);
  out.lease_ns = settings.lease_ns();
  verdict.require(out.lease_ns > 0, "auction.lease_ns", out.lease_ns);
  out.barrier_ns = settings.barrier_ns();
  verdict.require(out.barrier_ns >= 0, "auction.barrier_ns", out.barrier_ns);
  return out;
}

wire::TourSettings encode(const TourSettings& settings) {
  wire::TourSettings out;
  out.solver(static_cast<wire::TourSolver>(settings.solver));
  out.seed(settings.seed);
  out.epochs(settings.epochs);
  out.iterations(settings.iterations);
  return out;
}

TourSettings decode(const wire::TourSettings& settings, Verdict& verdict) {
  return {enumerator<TourSolver>(settings.solver(), wire::TOUR_CRSOM_LS, "tour.solver", verdict),
          settings.seed(), settings.epochs(), settings.iterations()};
}

Arc decode(const wire::Arc& arc, std::size_t position, Verdict& verdict) {
  Arc out{ArcId{static_cast<std::uint32_t>(position)},
          enumerator<ArcKind>(arc.kind(), wire::ARC_GAP, "arc.kind", verdict),
          decode(arc.waypoints(), verdict),
          enumerator<Payload>(arc.payload(), wire::PAYLOAD_CAMERA, "arc.payload", verdict)};
  verdict.require(out.waypoints.size() >= 2, "arc.waypoints.size", out.waypoints.size());
  for (std::size_t i = 1; i < out.waypoints.size(); ++i)
    verdict.require(out.waypoints[i].position_m != out.waypoints[i - 1].position_m,
                    "arc.waypoints: repeated position at", i);
  return out;
}

wire::Airspace encode(const Airspace& airspace) {
  wire::Airspace out;
  out.low_m(encode(airspace.low_m));
  out.cell_m(airspace.cell_m);
  out.cells(airspace.cells);
  out.runs(airspace.runs);
  for (const Access& access : airspace.accesses) {
    wire::Access& next = out.accesses().emplace_back();
    next.arc(access.arc.value);
    next.waypoint(access.waypoint);
    for (const AccessPoint& p : access.points)
      next.points().emplace_back().position_m(encode(p.position_m));
  }
  return out;
}

/// An access begins at a waypoint of one of the mission's arcs.
void check_begin(const Access& access, const std::vector<Arc>& arcs, Verdict& verdict) {
  const std::size_t arc = access.arc.value;
  verdict.require(arc < arcs.size(), "airspace.access.arc", arc);
  if (!verdict.accepted()) return;
  const auto& waypoints = arcs[arc].waypoints;
  verdict.require(access.waypoint < waypoints.size() && !access.points.empty() &&
                      waypoints[access.waypoint].position_m == access.points.front().position_m,
                  "airspace.access.waypoint", access.waypoint);
}

Airspace decode(const wire::Airspace& airspace, const std::vector<Arc>& arcs, Verdict& verdict) {
  Airspace out;
  out.low_m = decode(airspace.low_m(), "airspace.low_m", verdict);
  out.cell_m = airspace.cell_m();
  verdict.finite("airspace.cell_m", out.cell_m);
  out.cells = airspace.cells();
  out.runs = airspace.runs();
  for (const wire::Access& access : airspace.accesses()) {
    out.accesses.push_back({ArcId{access.arc()}, access.waypoint(), {}});
    for (const wire::Place& p : access.points())
      out.accesses.back().points.push_back(
          {decode(p.position_m(), "airspace.access.points", verdict)});
    check_begin(out.accesses.back(), arcs, verdict);
  }
  if (const auto reason = unsound(out)) verdict.require(false, "airspace", *reason);
  return out;
}

Uav decode(const wire::Uav& uav, std::uint32_t previous_id, Verdict& verdict) {
  verdict.require(uav.id() > previous_id, "fleet.id", uav.id());
  verdict.require(std::isfinite(uav.speed_mps()) && uav.speed_mps() > 0, "fleet.speed_mps",
                  uav.speed_mps());
  Uav out{AgentId{uav.id()}, decode(uav.home_m(), "fleet.home_m", verdict), uav.speed_mps()};
  verdict.finite("fleet.endurance_s", uav.endurance_s());
  if (uav.has_endurance()) {
    out.endurance_s = uav.endurance_s();
    verdict.require(*out.endurance_s > 0, "fleet.endurance_s", *out.endurance_s);
  }
  out.payload = enumerator<Payload>(uav.payload(), wire::PAYLOAD_CAMERA, "fleet.payload", verdict);
  return out;
}

void check_sizes(const wire::Mission& mission, Verdict& verdict) {
  verdict.text("name", mission.name());
  verdict.require(!mission.arcs().empty(), "arcs.size", 0);
  verdict.require(!mission.fleet().empty(), "fleet.size", 0);
  verdict.at_most("arcs", mission.arcs().size(), kMaxArcs);
  verdict.at_most("fleet", mission.fleet().size(), kMaxAgents);
  std::size_t waypoints = 0;
  for (const wire::Arc& arc : mission.arcs()) waypoints += arc.waypoints().size();
  verdict.at_most("arcs.waypoints", waypoints, kMaxWaypoints);
  verdict.at_most("airspace.accesses", mission.airspace().accesses().size(), kMaxArcs);
  std::size_t points = 0;
  for (const wire::Access& access : mission.airspace().accesses()) points += access.points().size();
  verdict.at_most("airspace.accesses.points", points, kMaxWaypoints);
}

}  // namespace

wire::Mission to_wire(const Mission& mission) {
  wire::Mission out;
  out.schema_version(wire::SCHEMA_VERSION);
  out.id(mission.id);
  out.name(mission.name);
  out.arcs().resize(mission.arcs.size());
  for (std::size_t i = 0; i < mission.arcs.size(); ++i) {
    out.arcs()[i].kind(static_cast<wire::ArcKind>(mission.arcs[i].kind));
    out.arcs()[i].payload(static_cast<wire::Payload>(mission.arcs[i].payload));
    out.arcs()[i].waypoints(encode(mission.arcs[i].waypoints));
  }
  out.fleet().resize(mission.fleet.size());
  for (std::size_t i = 0; i < mission.fleet.size(); ++i) {
    out.fleet()[i].id(mission.fleet[i].id.value);
    out.fleet()[i].home_m(encode(mission.fleet[i].home_m));
    out.fleet()[i].speed_mps(mission.fleet[i].speed_mps);
    out.fleet()[i].has_endurance(mission.fleet[i].endurance_s.has_value());
    out.fleet()[i].endurance_s(mission.fleet[i].endurance_s.value_or(0));
    out.fleet()[i].payload(static_cast<wire::Payload>(mission.fleet[i].payload));
  }
  out.airspace(encode(mission.airspace));
  out.auction(encode(mission.auction));
  out.tour(encode(mission.tour));
  return out;
}

Decoded<Mission> from_wire(const wire::Mission& mission) {
  Verdict verdict(mission.schema_version());
  check_sizes(mission, verdict);
  if (!verdict.accepted()) return verdict.on(Mission{});
  Mission out;
  out.id = mission.id();
  out.name = mission.name();
  for (const wire::Arc& arc : mission.arcs())
    out.arcs.push_back(decode(arc, out.arcs.size(), verdict));
  for (const wire::Uav& uav : mission.fleet())
    out.fleet.push_back(decode(uav, out.fleet.empty() ? 0 : out.fleet.back().id.value, verdict));
  out.airspace = decode(mission.airspace(), out.arcs, verdict);
  out.auction = decode(mission.auction(), verdict);
  out.tour = decode(mission.tour(), verdict);
  return verdict.on(std::move(out));
}

wire::Control to_wire(const ControlMessage& message) {
  wire::Control out;
  out.schema_version(wire::SCHEMA_VERSION);
  out.mission_digest(message.mission_digest);
  out.command(static_cast<wire::Command>(message.command));
  out.reason(message.reason);
  return out;
}

Decoded<ControlMessage> from_wire(const wire::Control& message) {
  Verdict verdict(message.schema_version());
  verdict.text("reason", message.reason());
  ControlMessage out{
      message.mission_digest(),
      enumerator<Command>(message.command(), wire::COMMAND_ABORT, "command", verdict),
      message.reason()};
  return verdict.on(std::move(out));
}

}  // namespace arcbid
