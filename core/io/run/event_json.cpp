// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/run/event_json.hpp"

#include <fmt/format.h>

#include <array>
#include <type_traits>

namespace arcbid {

using nlohmann::json;

namespace {

template <class T, class F>
json list(const std::vector<T>& items, F each) {
  json out = json::array();
  for (const T& item : items) out.push_back(each(item));
  return out;
}

json ids(const std::vector<AgentId>& agents) {
  return list(agents, [](AgentId a) { return a.value; });
}

json to_json(const StatementKey& key) {
  return {hex(key.incarnation), key.dead, key.version};
}

json to_json(const Header& header) {
  return {{"sender", header.sender.value},
          {"incarnation", hex(header.incarnation)},
          {"sequence", header.sequence},
          {"mission", hex(header.mission_digest)},
          {"tasks", hex(header.task_digest)}};
}

json winner(const Belief& belief) {
  return belief.winner ? json(belief.winner->value) : json(nullptr);
}

/// [winner or null, bid], an entry for each task.
json to_json(const std::vector<Belief>& beliefs) {
  return list(beliefs, [](const Belief& b) { return json::array({winner(b), b.bid}); });
}

/// [task, flown backwards], in flying order.
json to_json(const std::vector<PathStop>& path) {
  return list(path, [](const PathStop& s) { return json::array({s.task.value, s.reversed}); });
}

json to_json(const StatementBody& body) {
  if (const auto* claims = std::get_if<Claims>(&body))
    return {{"claims", list(claims->bundle, [](const Claim& c) {
               return json::array({c.task.value, c.bid});
             })}};
  const Table& table = std::get<Table>(body);
  return {{"beliefs", to_json(table.beliefs)},
          {"timestamps", list(table.timestamps, [](std::uint64_t s) { return hex(s); })}};
}

}  // namespace

std::string hex(std::uint64_t value) {
  return fmt::format("{:016x}", value);
}

json to_json(const Vec3& point) {
  return {point.x(), point.y(), point.z()};
}

json to_json(const Waypoint& w) {
  return {w.position_m.x(), w.position_m.y(), w.position_m.z(), w.look.x(), w.look.y(), w.look.z()};
}

json to_json(const Mission& mission) {
  const AuctionSettings& a = mission.auction;
  const auto uav = [](const Uav& u) {
    return json{{"agent", u.id.value}, {"home_m", to_json(u.home_m)}, {"speed_mps", u.speed_mps}};
  };
  const auto arc = [](const Arc& one) {
    return json{{"arc", one.id.value},
                {"kind", name(one.kind)},
                {"length_m", length_m(one.waypoints)},
                {"waypoints", list(one.waypoints, [](const Waypoint& w) { return to_json(w); })}};
  };
  return {{"id", hex(mission.id)},
          {"digest", hex(digest(mission))},
          {"name", mission.name},
          {"fleet", list(mission.fleet, uav)},
          {"arcs", list(mission.arcs, arc)},
          {"auction",
           {{"policy", name_of(a.policy)},
            {"score", name_of(a.score)},
            {"discount_per_s", a.discount_per_s},
            {"split_m", a.split_m ? json(*a.split_m) : json(nullptr)},
            {"max_tasks", a.max_tasks},
            {"bundle_limit", a.bundle_limit},
            {"audit_bids", a.audit_bids},
            {"tick_ns", a.tick_ns},
            {"lease_ns", a.lease_ns},
            {"barrier_ns", a.barrier_ns}}},
          {"tour", {{"seed", mission.tour.seed}, {"epochs", mission.tour.epochs}}}};
}

json to_json(const Statement& statement) {
  json out = to_json(statement.body);
  out["agent"] = statement.agent.value;
  out["key"] = to_json(statement.key);
  return out;
}

json to_json(const BidMessage& message) {
  return {{"header", to_json(message.header)}, {"statement", to_json(message.statement)}};
}

json to_json(const RelayMessage& message) {
  return {{"header", to_json(message.header)}, {"statement", to_json(message.statement)}};
}

json to_json(const StatusMessage& status) {
  return {{"header", to_json(status.header)},
          {"phase", static_cast<int>(status.phase)},
          {"round", status.round},
          {"matched_peers", status.matched_peers},
          {"view_hash", hex(status.view_hash)},
          {"ready", ids(status.ready)},
          {"whole", status.whole},
          {"view", list(status.view,
                        [](const Held& h) {
                          return json::array({h.agent.value, to_json(h.key)});
                        })},
          {"heartbeats", list(status.heartbeats, [](const Pulse& p) {
             return json::array({p.agent.value, hex(p.heartbeat.incarnation), p.heartbeat.counter});
           })}};
}

std::string_view kind(const Event& event) {
  constexpr std::array names{"tick", "bid", "relay", "status", "route_published"};
  static_assert(names.size() == std::variant_size_v<decltype(event.what)>);
  return names[event.what.index()];
}

json to_json(const Event& event) {
  return std::visit(
      [](const auto& what) -> json {
        using What = std::decay_t<decltype(what)>;
        if constexpr (std::is_same_v<What, Tick>)
          return {{"matched_peers", what.matched_peers}};
        else if constexpr (std::is_same_v<What, RoutePublished>)
          return {{"view_hash", hex(what.view_hash)}};
        else
          return to_json(what);
      },
      event.what);
}

json to_json(const DecisionMade& decision) {
  json out = to_json(decision.body);
  out["round"] = decision.round;
  out["changed"] = decision.changed;
  out["key"] = to_json(decision.key);
  out["path"] = to_json(decision.path);
  return out;
}

json to_json(const Agreement& agreement) {
  return {{"view_hash", hex(agreement.view_hash)},
          {"round", agreement.round},
          {"members", ids(agreement.members)},
          {"winners", to_json(agreement.winners)},
          {"path", to_json(agreement.path)}};
}

}  // namespace arcbid
