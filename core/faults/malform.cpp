// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/faults/malform.hpp"

#include <limits>

namespace arcbid {
namespace {

constexpr std::uint32_t versions_ahead = 1000;

/// Claims one task more, or changes the first belief of a table.
void spoil(StatementBody& body, TaskId task, std::optional<AgentId> winner, double bid) {
  if (auto* claims = std::get_if<Claims>(&body))
    claims->bundle.push_back({task, bid});
  else if (auto& table = std::get<Table>(body); task.value < table.beliefs.size())
    table.beliefs[task.value] = {winner, bid};
  else
    table.beliefs.push_back({winner, bid});
}

}  // namespace

BidMessage malformed(const BidMessage& sound, Malformation how, std::size_t tasks) {
  BidMessage bad = sound;
  Statement& statement = bad.statement;
  statement.key.version += versions_ahead;
  const AgentId self = statement.agent;
  switch (how) {
    case Malformation::nan_bid:
      spoil(statement.body, {0}, self, std::numeric_limits<double>::quiet_NaN());
      break;
    case Malformation::unknown_task:
      spoil(statement.body, {static_cast<std::uint32_t>(tasks)}, self, 1);
      break;
    case Malformation::unknown_agent:
      bad.header.sender = statement.agent = {9999};
      break;
    case Malformation::wrong_mission:
      bad.header.mission_digest ^= 1;
      break;
    case Malformation::wrong_tasks:
      bad.header.task_digest ^= 1;
      break;
    case Malformation::over_bid:
    case Malformation::replay:
      break;
  }
  return bad;
}

BidMessage over_bid(const BidMessage& sound, std::size_t tasks) {
  BidMessage bad = sound;
  Statement& statement = bad.statement;
  statement.key.version += versions_ahead;
  if (auto* claims = std::get_if<Claims>(&statement.body)) claims->bundle.clear();
  for (std::uint32_t j = 0; j < tasks; ++j) spoil(statement.body, {j}, statement.agent, 1e9);
  return bad;
}

}  // namespace arcbid
