// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.hpp"
#include "idl/convert_common.hpp"

namespace arcbid {

namespace {

using convert::decode;
using convert::encode;
using convert::enumerator;
using convert::Verdict;

wire::Header encode(const Header& header) {
  wire::Header out;
  out.schema_version(wire::SCHEMA_VERSION);
  out.incarnation(header.incarnation);
  out.sequence_number(header.sequence);
  out.mission_digest(header.mission_digest);
  out.task_digest(header.task_digest);
  return out;
}

Header decode(const wire::Header& header, std::uint32_t sender, Verdict& verdict) {
  verdict.require(sender > 0, "sender", sender);
  return {AgentId{sender}, header.incarnation(), header.sequence_number(), header.mission_digest(),
          header.task_digest()};
}

wire::StatementKey encode(const StatementKey& key) {
  wire::StatementKey out;
  out.incarnation(key.incarnation);
  out.dead(key.dead);
  out.version(key.version);
  return out;
}

StatementKey decode(const wire::StatementKey& key) {
  return {key.incarnation(), key.dead(), key.version()};
}

wire::StatementBody encode(const Claims& claims) {
  std::vector<wire::Claim> bundle(claims.bundle.size());
  for (std::size_t i = 0; i < bundle.size(); ++i) {
    bundle[i].task(claims.bundle[i].task.value);
    bundle[i].bid(claims.bundle[i].bid);
  }
  wire::StatementBody out;
  out.bundle(std::move(bundle));
  return out;
}

wire::StatementBody encode(const Table& table) {
  wire::Table rows;
  rows.beliefs().resize(table.beliefs.size());
  for (std::size_t j = 0; j < table.beliefs.size(); ++j) {
    const Belief& belief = table.beliefs[j];
    rows.beliefs()[j].has_winner(belief.winner.has_value());
    rows.beliefs()[j].winner(belief.winner.value_or(AgentId{}).value);
    rows.beliefs()[j].bid(belief.bid);
  }
  rows.timestamps(table.timestamps);
  wire::StatementBody out;
  out.table(std::move(rows));
  return out;
}

Claims decode(const std::vector<wire::Claim>& bundle, Verdict& verdict) {
  verdict.at_most("bundle", bundle.size(), kMaxArcs);
  Claims out;
  if (!verdict.accepted()) return out;
  for (const wire::Claim& claim : bundle) {
    verdict.finite("bundle.bid", claim.bid());
    out.bundle.push_back({TaskId{claim.task()}, claim.bid()});
  }
  return out;
}

Table decode(const wire::Table& table, Verdict& verdict) {
  verdict.at_most("table.beliefs", table.beliefs().size(), kMaxArcs);
  verdict.at_most("table.timestamps", table.timestamps().size(), kMaxArcs);
  Table out;
  if (!verdict.accepted()) return out;
  for (const wire::Belief& belief : table.beliefs()) {
    verdict.finite("table.bid", belief.bid());
    out.beliefs.push_back({std::nullopt, belief.bid()});
    if (belief.has_winner()) out.beliefs.back().winner = AgentId{belief.winner()};
  }
  out.timestamps = table.timestamps();
  return out;
}

wire::Statement encode(const Statement& statement) {
  wire::Statement out;
  out.version(encode(statement.key));
  out.body(std::visit([](const auto& body) { return encode(body); }, statement.body));
  return out;
}

Statement decode(const wire::Statement& statement, std::uint32_t agent, Verdict& verdict) {
  verdict.require(agent > 0, "origin", agent);
  Statement out{AgentId{agent}, decode(statement.version()), {}};
  const wire::BodyKind kind = statement.body()._d();
  if (kind == wire::BODY_CLAIMS)
    out.body = decode(statement.body().bundle(), verdict);
  else if (kind == wire::BODY_TABLE)
    out.body = decode(statement.body().table(), verdict);
  else
    verdict.require(false, "statement.body", static_cast<std::uint32_t>(kind));
  return out;
}

wire::Held encode(const Held& held) {
  wire::Held out;
  out.agent(held.agent.value);
  out.version(encode(held.key));
  return out;
}

wire::Pulse encode(const Pulse& pulse) {
  wire::Pulse out;
  out.agent(pulse.agent.value);
  out.heartbeat().incarnation(pulse.heartbeat.incarnation);
  out.heartbeat().counter(pulse.heartbeat.counter);
  return out;
}

wire::RouteLeg encode(const RouteLeg& leg) {
  wire::RouteLeg out;
  out.on_arc(leg.arc.has_value());
  out.arc(leg.arc.value_or(ArcId{}).value);
  out.from_m(leg.from_m);
  out.to_m(leg.to_m);
  out.waypoints(encode(leg.waypoints));
  return out;
}

RouteLeg decode(const wire::RouteLeg& leg, Verdict& verdict) {
  verdict.finite("leg.from_m", leg.from_m());
  verdict.finite("leg.to_m", leg.to_m());
  RouteLeg out{std::nullopt, leg.from_m(), leg.to_m(), decode(leg.waypoints(), verdict)};
  if (leg.on_arc()) out.arc = ArcId{leg.arc()};
  return out;
}

}  // namespace

wire::Bids to_wire(const BidMessage& message) {
  check(message.statement.agent == message.header.sender, "bids state the sender's own bundle");
  wire::Bids out;
  out.header(encode(message.header));
  out.sender(message.header.sender.value);
  out.statement(encode(message.statement));
  return out;
}

Decoded<BidMessage> from_wire(const wire::Bids& message) {
  Verdict verdict(message.header().schema_version());
  BidMessage out{decode(message.header(), message.sender(), verdict),
                 decode(message.statement(), message.sender(), verdict)};
  return verdict.on(std::move(out));
}

wire::Relay to_wire(const RelayMessage& message) {
  wire::Relay out;
  out.header(encode(message.header));
  out.sender(message.header.sender.value);
  out.origin(message.statement.agent.value);
  out.statement(encode(message.statement));
  return out;
}

Decoded<RelayMessage> from_wire(const wire::Relay& message) {
  Verdict verdict(message.header().schema_version());
  RelayMessage out{decode(message.header(), message.sender(), verdict),
                   decode(message.statement(), message.origin(), verdict)};
  return verdict.on(std::move(out));
}

wire::Status to_wire(const StatusMessage& message) {
  wire::Status out;
  out.header(encode(message.header));
  out.sender(message.header.sender.value);
  out.phase(static_cast<wire::Phase>(message.phase));
  out.round(message.round);
  out.matched_peers(message.matched_peers);
  out.view_hash(message.view_hash);
  for (const AgentId agent : message.ready) out.ready().push_back(agent.value);
  out.whole(message.whole);
  for (const Held& held : message.view) out.view().push_back(encode(held));
  for (const Pulse& pulse : message.heartbeats) out.heartbeats().push_back(encode(pulse));
  return out;
}

Decoded<StatusMessage> from_wire(const wire::Status& message) {
  Verdict verdict(message.header().schema_version());
  verdict.at_most("ready", message.ready().size(), kMaxAgents);
  verdict.at_most("view", message.view().size(), kMaxAgents);
  verdict.at_most("heartbeats", message.heartbeats().size(), kMaxAgents);
  StatusMessage out;
  out.header = decode(message.header(), message.sender(), verdict);
  out.phase = enumerator<Phase>(message.phase(), wire::PHASE_ROUTED, "phase", verdict);
  if (!verdict.accepted()) return verdict.on(StatusMessage{});
  out.round = message.round();
  out.matched_peers = message.matched_peers();
  out.view_hash = message.view_hash();
  for (const std::uint32_t agent : message.ready()) out.ready.push_back(AgentId{agent});
  out.whole = message.whole();
  for (const wire::Held& held : message.view())
    out.view.push_back({AgentId{held.agent()}, decode(held.version())});
  for (const wire::Pulse& pulse : message.heartbeats())
    out.heartbeats.push_back(
        {AgentId{pulse.agent()}, {pulse.heartbeat().incarnation(), pulse.heartbeat().counter()}});
  return out;
}

wire::Route to_wire(const RouteMessage& message) {
  wire::Route out;
  out.header(encode(message.header));
  out.sender(message.header.sender.value);
  out.view_hash(message.view_hash);
  out.owners_digest(message.owners_digest);
  out.length_m(message.length_m);
  out.time_s(message.time_s);
  for (const RouteLeg& leg : message.legs) out.legs().push_back(encode(leg));
  return out;
}

Decoded<RouteMessage> from_wire(const wire::Route& message) {
  Verdict verdict(message.header().schema_version());
  verdict.finite("length_m", message.length_m());
  verdict.finite("time_s", message.time_s());
  verdict.at_most("legs", message.legs().size(), kMaxArcs);
  std::size_t waypoints = 0;
  for (const wire::RouteLeg& leg : message.legs()) waypoints += leg.waypoints().size();
  verdict.at_most("legs.waypoints", waypoints, kMaxWaypoints);
  RouteMessage out;
  out.header = decode(message.header(), message.sender(), verdict);
  if (!verdict.accepted()) return verdict.on(RouteMessage{});
  out.view_hash = message.view_hash();
  out.owners_digest = message.owners_digest();
  out.length_m = message.length_m();
  out.time_s = message.time_s();
  for (const wire::RouteLeg& leg : message.legs()) out.legs.push_back(decode(leg, verdict));
  return verdict.on(std::move(out));
}

}  // namespace arcbid
