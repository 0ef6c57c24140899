// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/replay/diff.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace arcbid {
namespace {

using nlohmann::json;

/// Leaves that differ, by their names; lists as a whole.
void compare(const json& a, const json& b, const std::string& name, std::vector<std::string>& out) {
  if (a == b) return;
  if (a.is_object() && b.is_object()) {
    for (const auto& [key, value] : a.items())
      compare(value, b.value(key, json()), name.empty() ? key : name + "." + key, out);
  } else if (a.is_array() && b.is_array()) {
    out.push_back(a.size() == b.size() ? fmt::format("{}: {} of them, not the same", name, a.size())
                                       : fmt::format("{}: {} and {}", name, a.size(), b.size()));
  } else {
    out.push_back(fmt::format("{}: {} and {}", name, a.dump(), b.dump()));
  }
}

std::vector<std::string> settings_of(const Mission& a, const Mission& b) {
  json first = to_json(a), second = to_json(b);
  for (json* mission : {&first, &second}) mission->erase("id");  // every run has its own
  std::vector<std::string> out;
  compare(first, second, "", out);
  return out;
}

std::vector<Claim> bids_in(const StatementBody& body, AgentId agent) {
  if (const auto* claims = std::get_if<Claims>(&body)) return claims->bundle;
  std::vector<Claim> out;
  const std::vector<Belief>& beliefs = std::get<Table>(body).beliefs;
  for (std::uint32_t j = 0; j < beliefs.size(); ++j)
    if (beliefs[j].winner == agent) out.push_back({{j}, beliefs[j].bid});
  return out;
}
std::optional<double> bid_for(const std::vector<Claim>& bids, TaskId task) {
  for (const Claim& claim : bids)
    if (claim.task == task) return claim.bid;
  return std::nullopt;
}

/// One agent's life in one of the runs.
struct Side {
  const OpenRun& of;
  std::size_t life;

  const LifeLog& log() const { return of.run.lives[life]; }
  const std::vector<RunIndex::Decision>& decisions() const {
    return of.explainer.index().decisions(life);
  }
  const StatementBody* body(AgentId agent, const StatementKey& key) const {
    return of.explainer.index().body(agent, key);
  }
  /// What was held of a member at a decision; null: nothing.
  const Learnt* held(std::size_t member, const RunIndex::Decision& at) const {
    const auto& learnt = log().learnt()[member];
    const auto after = std::upper_bound(learnt.begin(), learnt.end(), at.mark,
                                        [](std::size_t m, const Learnt& l) { return m < l.mark; });
    return after == learnt.begin() ? nullptr : &*std::prev(after);
  }
  std::string describe(const Learnt* learnt) const {
    if (!learnt) return "nothing";
    if (learnt->key.dead) return "that it is dead";
    const Mark& mark = log().marks()[learnt->mark];
    const Source source{mark.heard.value_or(MessageId{}), mark.event == 2};
    return fmt::format("version {} ({} at {:.6f} s)", learnt->key.version,
                       mark.heard ? arcbid::describe(source) : "no message",
                       static_cast<double>(mark.t_ns) * 1e-9);
  }
};

std::vector<std::string> differently_informed(const Side& a, const RunIndex::Decision& in_a,
                                              const Side& b, const RunIndex::Decision& in_b) {
  std::vector<std::string> out;
  const std::vector<Uav>& fleet = a.of.run.mission->fleet;
  for (std::size_t k = 0; k < fleet.size(); ++k) {
    if (fleet[k].id == a.log().agent()) continue;
    const Learnt *first = a.held(k, in_a), *second = b.held(k, in_b);
    const auto* said = first ? a.body(fleet[k].id, first->key) : nullptr;
    const auto* said_b = second ? b.body(fleet[k].id, second->key) : nullptr;
    const bool same = said && said_b ? *said == *said_b : !said && !said_b;
    if (!same)
      out.push_back(fmt::format("of agent {} it held {} and {}", fleet[k].id.value,
                                a.describe(first), b.describe(second)));
  }
  return out;
}

/// The statement in force at the nth change on each side, until one is not like the other.
std::optional<RunDiff::Parting> parting(const Side& a, const Side& b) {
  const AgentId agent = a.log().agent();
  const auto &in_a = a.decisions(), &in_b = b.decisions();
  if (in_a.empty() || in_b.empty()) return std::nullopt;
  for (std::size_t n = 0; n < std::max(in_a.size(), in_b.size()); ++n) {
    // Whoever made no such decision stays with its last one.
    const RunIndex::Decision &first = in_a[std::min(n, in_a.size() - 1)],
                             &second = in_b[std::min(n, in_b.size() - 1)];
    const auto *said = a.body(agent, first.key), *said_b = b.body(agent, second.key);
    if (!said || !said_b || *said == *said_b) continue;
    RunDiff::Parting out;
    out.agent = agent;
    out.round = n < in_a.size() ? first.round : second.round;
    out.t_ns = {a.log().marks()[first.mark].t_ns, b.log().marks()[second.mark].t_ns};
    const auto bids = bids_in(*said, agent), bids_b = bids_in(*said_b, agent);
    for (const auto* claims : {&bids, &bids_b})
      for (const Claim& claim : *claims)
        if (bid_for(bids, claim.task) != bid_for(bids_b, claim.task)) {
          out.task = claim.task;
          out.bid = {bid_for(bids, claim.task), bid_for(bids_b, claim.task)};
          out.before = differently_informed(a, first, b, second);
          return out;
        }
  }
  return std::nullopt;
}

/// Lives of an agent are compared in their order.
std::optional<RunDiff::Parting> first_parting(const OpenRun& a, const OpenRun& b) {
  std::optional<RunDiff::Parting> first;
  std::size_t from = 0;
  for (std::size_t l = 0; l < a.run.lives.size(); ++l) {
    const AgentId agent = a.run.lives[l].agent();
    const bool is_next = l > 0 && a.run.lives[l - 1].agent() == agent;
    if (!is_next) from = 0;
    while (from < b.run.lives.size() && b.run.lives[from].agent() < agent) ++from;
    if (from >= b.run.lives.size() || b.run.lives[from].agent() != agent) continue;
    const auto found = parting({a, l}, {b, from++});
    if (found && (!first || std::tuple(found->round, found->t_ns[0]) <
                                std::tuple(first->round, first->t_ns[0])))
      first = found;
  }
  return first;
}

std::vector<RunDiff::Figure> figures_of(const json& a, const json& b) {
  const auto value = [](const json& result, const char* pointer) -> std::optional<double> {
    const json::json_pointer place(pointer);
    if (!result.is_object() || !result.contains(place) || !result.at(place).is_number())
      return std::nullopt;
    return result.at(place).get<double>();
  };
  std::vector<RunDiff::Figure> out;
  for (const auto& [name, pointer] : {std::pair{"makespan s", "/makespan_s"},
                                      {"total length m", "/total_length_m"},
                                      {"time to agreement s", "/agreement/auction_s"},
                                      {"rounds", "/agreement/rounds"},
                                      {"messages", "/messages/sent"},
                                      {"bytes", "/messages/bytes"}})
    out.push_back({name, {value(a, pointer), value(b, pointer)}});
  return out;
}

}  // namespace

RunDiff diff(const OpenRun& a, const OpenRun& b) {
  RunDiff out;
  out.settings = settings_of(*a.run.mission, *b.run.mission);
  out.same_tasks = a.run.tasks.digest == b.run.tasks.digest;
  out.figures = figures_of(a.run.result, b.run.result);
  if (!out.same_tasks) return out;
  if (states_claims(a.run.mission->auction.policy) == states_claims(b.run.mission->auction.policy))
    out.parting = first_parting(a, b);
  const auto &owners = a.explainer.owners(), &owners_b = b.explainer.owners();
  for (std::uint32_t j = 0; j < owners.size(); ++j)
    if (owners[j].winner != owners_b[j].winner) out.owners.push_back({j});
  return out;
}

}  // namespace arcbid
