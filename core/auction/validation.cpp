// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/auction/validation.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

namespace arcbid {
namespace {

using Reason = std::optional<std::string>;

Reason implausible(std::uint64_t incarnation, std::uint64_t last = last_incarnation) {
  if (incarnation <= last) return {};
  return fmt::format("life {} is beyond {}", incarnation, last);
}

Reason beyond_the_limit(AgentId agent, std::size_t tasks, const Expected& expected) {
  if (expected.bundle_limit == 0 || tasks <= expected.bundle_limit) return {};
  return fmt::format("agent {} takes {} tasks, more than {}", agent.value, tasks,
                     expected.bundle_limit);
}

Reason refusal(AgentId agent, const Claims& claims, const Expected& expected, const View&) {
  if (!states_claims(expected.policy))
    return fmt::format("claims, but the mission's policy is {}", name_of(expected.policy));
  std::vector<bool> seen(expected.tasks, false);
  for (const Claim& claim : claims.bundle) {
    if (claim.task.value >= expected.tasks)
      return fmt::format("task {} is outside [0, {})", claim.task.value, expected.tasks);
    if (!std::isfinite(claim.bid))
      return fmt::format("the bid for task {} is {}", claim.task.value, claim.bid);
    if (seen[claim.task.value]) return fmt::format("task {} is claimed twice", claim.task.value);
    seen[claim.task.value] = true;
  }
  return beyond_the_limit(agent, claims.bundle.size(), expected);
}

Reason refusal(AgentId agent, const Table& table, const Expected& expected, const View& view) {
  if (states_claims(expected.policy))
    return fmt::format("a table, but the mission's policy is {}", name_of(expected.policy));
  if (table.beliefs.size() != expected.tasks)
    return fmt::format("a table of {} tasks, not {}", table.beliefs.size(), expected.tasks);
  const bool by_task = expected.policy == PolicyKind::acbba;
  const std::size_t timestamps = by_task ? expected.tasks : view.roster().size();
  if (table.timestamps.size() != timestamps)
    return fmt::format("{} timestamps, not {}", table.timestamps.size(), timestamps);
  for (const std::uint64_t time : table.timestamps)
    if (by_task && time > last_timestamp)
      return fmt::format("timestamp {} is beyond {}", time, last_timestamp);
  std::size_t own = 0;
  for (std::size_t j = 0; j < table.beliefs.size(); ++j) {
    const Belief& belief = table.beliefs[j];
    own += belief.winner == agent;
    if (!std::isfinite(belief.bid)) return fmt::format("the bid for task {} is {}", j, belief.bid);
    if (belief.winner && !view.position(*belief.winner))
      return fmt::format("task {} is won by agent {}, who is not of the fleet", j,
                         belief.winner->value);
  }
  return beyond_the_limit(agent, own, expected);
}

/// Entries must name agents of the fleet, each once, in ascending order.
template <class Entry>
Reason out_of_order(const std::vector<Entry>& entries, const View& view) {
  for (std::size_t e = 0; e < entries.size(); ++e) {
    const AgentId agent = entries[e].agent;
    if (!view.position(agent))
      return fmt::format("it speaks of agent {}, who is not of the fleet", agent.value);
    if (e > 0 && !(entries[e - 1].agent < agent))
      return fmt::format("it speaks of agent {} after agent {}", agent.value,
                         entries[e - 1].agent.value);
  }
  return {};
}

}  // namespace

Reason refusal(const Header& header, const Expected& expected, const View& view) {
  if (!view.position(header.sender))
    return fmt::format("agent {} is not of the fleet", header.sender.value);
  if (header.sender == expected.self)
    return fmt::format("another process says it is agent {}", header.sender.value);
  if (header.mission_digest != expected.mission_digest)
    return fmt::format("agent {} flies mission {:016x}, not {:016x}", header.sender.value,
                       header.mission_digest, expected.mission_digest);
  if (header.task_digest != expected.task_digest)
    return fmt::format("agent {} split the arcs differently: {:016x}, not {:016x}",
                       header.sender.value, header.task_digest, expected.task_digest);
  if (header.incarnation == 0) return fmt::format("agent {} has no life", header.sender.value);
  return implausible(header.incarnation);
}

Reason refusal(const Statement& statement, const Expected& expected, const View& view) {
  if (!view.position(statement.agent))
    return fmt::format("a statement of agent {}, who is not of the fleet", statement.agent.value);
  // What is said in this agent's own name must leave a later life to answer with.
  const bool own = statement.agent == expected.self;
  if (const Reason reason = implausible(statement.key.incarnation, last_incarnation - own))
    return reason;
  if (statement.key.dead) {
    const auto* claims = std::get_if<Claims>(&statement.body);
    if (!claims || !claims->bundle.empty()) return "a tombstone that claims tasks";
    return {};
  }
  if (statement.key.incarnation == 0)
    return fmt::format("a statement of agent {} without a life", statement.agent.value);
  return std::visit(
      [&](const auto& body) { return refusal(statement.agent, body, expected, view); },
      statement.body);
}

Reason refusal(const StatusMessage& status, const View& view) {
  const std::size_t members = view.roster().size();
  if (status.whole && status.view.size() != members)
    return fmt::format("a whole view of {} members, not {}", status.view.size(), members);
  if (const Reason reason = out_of_order(status.view, view)) return reason;
  if (const Reason reason = out_of_order(status.heartbeats, view)) return reason;
  for (const Held& held : status.view)
    if (const Reason reason = implausible(held.key.incarnation)) return reason;
  for (const Pulse& pulse : status.heartbeats)
    if (const Reason reason = implausible(pulse.heartbeat.incarnation)) return reason;
  for (const AgentId agent : status.ready)
    if (!view.position(agent))
      return fmt::format("agent {} is called ready but is not of the fleet", agent.value);
  return {};
}

}  // namespace arcbid
