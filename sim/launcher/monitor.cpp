// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/launcher/monitor.hpp"

#include <algorithm>

namespace arcbid {

using nlohmann::json;

Monitor::Monitor(const std::vector<AgentId>& fleet) {
  for (const AgentId agent : fleet) agents_[agent.value];
}

void Monitor::heard(std::uint32_t id, const json& event) {
  const std::string kind = event.value("event", "");
  if (kind == "traffic") {
    traffic_[id] = {event.at("sent"), event.at("received"), event.at("dropped"), event.at("bytes")};
    return;
  }
  if (kind == "links") {
    for (const json& link : event.at("links"))
      links_[{link.at("from"), id}] = {link.at("sent"), link.at("dropped"), link.at("delayed"),
                                       link.at("duplicated")};
    return;
  }
  if (kind == "warning") {
    const std::string text = event.at("text");
    if (std::find(warnings_.begin(), warnings_.end(), text) == warnings_.end())
      warnings_.push_back(text);
  } else if (kind == "published") {
    arcs_ = event.at("arcs").get<std::size_t>();
    metres_ = event.at("metres");
  } else if (kind == "complete") {
    complete_ = true;
  } else if (kind == "timeout") {
    given_up_ = true;
  } else if (kind == "refused") {
    if (refused_++ == 0) first_refusal_ = event.at("reason");
  }
  const auto found = agents_.find(id);
  if (found == agents_.end()) return;
  AgentProgress& agent = found->second;
  if (kind == "up") {
    agent.up = true;
  } else if (kind == "mission") {
    agent.has_mission = true;
    tasks_ = event.at("tasks");
  } else if (kind == "started") {
    agent.started = true;
    agent.started_s = event.at("time_s");
  } else if (kind == "round") {
    agent.round = event.at("round");
  } else if (kind == "reopened") {
    agent.agreed_hash.clear();
  } else if (kind == "died") {
    for (const json& dead : event.at("agents")) agents_.at(dead.get<std::uint32_t>()).gone = true;
  } else if (kind == "returned") {
    for (const json& back : event.at("agents")) agents_.at(back.get<std::uint32_t>()).gone = false;
  } else if (kind == "agreed") {
    agent.agreed_hash = event.at("view_hash");
    agent.agreed_s = event.at("time_s");
    agent.round = event.at("round");
  } else if (kind == "routed") {
    agent.routed_hash = event.at("view_hash");
    agent.members = event.at("members").get<std::set<std::uint32_t>>();
  }
}

LinkTraffic& LinkTraffic::operator+=(const LinkTraffic& more) {
  sent += more.sent;
  dropped += more.dropped;
  delayed += more.delayed;
  duplicated += more.duplicated;
  return *this;
}

void Monitor::starts(std::uint32_t id) {
  agents_.at(id) = {};
  for (auto link = links_.begin(); link != links_.end();) {
    if (link->first.second == id) {
      earlier_lives_[link->first] += link->second;
      link = links_.erase(link);
    } else {
      ++link;
    }
  }
}

std::map<std::pair<std::uint32_t, std::uint32_t>, LinkTraffic> Monitor::links() const {
  Links all = earlier_lives_;
  for (const auto& [link, traffic] : links_) all[link] += traffic;
  return all;
}

void Monitor::ended(std::uint32_t id) {
  if (const auto agent = agents_.find(id); agent != agents_.end()) agent->second.gone = true;
}

std::optional<Monitor::Outcome> Monitor::outcome() const {
  for (const auto& [id, witness] : agents_) {
    if (witness.routed_hash.empty() || witness.routed_hash != witness.agreed_hash) continue;
    Outcome outcome{witness.routed_hash, witness.members, 0, 0, 0};
    double started_s = witness.started_s;
    const bool all =
        std::all_of(witness.members.begin(), witness.members.end(), [&](std::uint32_t member) {
          const AgentProgress& agent = agents_.at(member);
          outcome.rounds = std::max(outcome.rounds, agent.round);
          outcome.agreed_s = std::max(outcome.agreed_s, agent.agreed_s);
          started_s = std::min(started_s, agent.started_s);
          return agent.routed_hash == witness.routed_hash &&
                 agent.agreed_hash == witness.routed_hash;
        });
    outcome.auction_s = outcome.agreed_s - started_s;
    if (all) return outcome;
  }
  return std::nullopt;
}

Traffic Monitor::traffic() const {
  Traffic sum;
  for (const auto& [id, t] : traffic_) {
    sum.sent += t.sent;
    sum.received += t.received;
    sum.dropped += t.dropped;
    sum.bytes += t.bytes;
  }
  return sum;
}

}  // namespace arcbid
