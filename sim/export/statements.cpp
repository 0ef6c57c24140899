// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/export/statements.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace arcbid {
namespace {

std::optional<std::size_t> position_in(const std::vector<PathStop>& path, TaskId task) {
  const auto at = std::find_if(path.begin(), path.end(),
                               [task](const PathStop& stop) { return stop.task == task; });
  if (at == path.end()) return std::nullopt;
  return static_cast<std::size_t>(at - path.begin());
}

std::vector<StatedClaim> claims_of(const StatementBody& body, AgentId self,
                                   const std::vector<PathStop>& path) {
  std::vector<StatedClaim> out;
  if (const auto* claims = std::get_if<Claims>(&body)) {
    for (const Claim& claim : claims->bundle)
      out.push_back({claim.task, claim.bid, position_in(path, claim.task)});
    return out;
  }
  const auto& beliefs = std::get<Table>(body).beliefs;
  for (std::uint32_t j = 0; j < beliefs.size(); ++j)
    if (beliefs[j].winner == self) out.push_back({{j}, beliefs[j].bid, position_in(path, {j})});
  return out;
}

std::string listed(const std::vector<AgentId>& agents) {
  std::string out;
  for (const AgentId agent : agents)
    out += fmt::format("{}{}", out.empty() ? "" : " ", agent.value);
  return out;
}

}  // namespace

std::optional<std::vector<StatedClaim>> Statements::stated_in(const RunStep& at) {
  Said& said = said_[&at.life];
  const Update& update = at.step.update;
  const StatementBody* body = nullptr;
  const auto say = [&](const StatementKey& key, const StatementBody& what) {
    if (key <= said.key) return;
    said.key = key;
    body = &what;
  };
  if (update.decision) {
    said.path = update.decision->path;
    say(update.decision->key, update.decision->body);
  }
  for (const BidMessage& bid : update.bids) say(bid.statement.key, bid.statement.body);
  if (body == nullptr) return std::nullopt;
  return claims_of(*body, at.life.agent(), said.path);
}

std::vector<Happening> happenings(const Update& update) {
  std::vector<Happening> out;
  if (!update.died.empty()) out.push_back({"died", listed(update.died)});
  if (!update.returned.empty()) out.push_back({"returned", listed(update.returned)});
  if (update.started) out.push_back({"started", ""});
  if (update.agreement_lost) out.push_back({"reopened", ""});
  if (update.agreed)
    out.push_back(
        {"agreed", fmt::format("view {:016x} round {} members {}", update.agreed->view_hash,
                               update.agreed->round, listed(update.agreed->members))});
  return out;
}

}  // namespace arcbid
