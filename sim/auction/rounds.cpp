// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/auction/rounds.hpp"

#include <algorithm>

#include "sim/auction/protocol.hpp"

namespace arcbid {
namespace {

std::unique_ptr<RoundsProtocol> protocol_of(const RoundsWorld& world) {
  if (states_claims(world.settings.policy)) return claims_rounds(world);
  return world.settings.policy == PolicyKind::acbba ? acbba_rounds(world) : cbba_rounds(world);
}

bool linked(Graph graph, std::size_t a, std::size_t b, std::size_t agents) {
  const std::size_t apart = a > b ? a - b : b - a;
  switch (graph) {
    case Graph::complete:
      return apart > 0;
    case Graph::ring:
      return apart == 1 || (agents > 2 && apart + 1 == agents);
    case Graph::line:
      return apart == 1;
    case Graph::star:
      return apart > 0 && (a == 0 || b == 0);
  }
  return false;
}

}  // namespace

std::vector<std::vector<std::size_t>> neighbours(Graph graph, std::size_t agents) {
  std::vector<std::vector<std::size_t>> out(agents);
  for (std::size_t a = 0; a < agents; ++a)
    for (std::size_t b = 0; b < agents; ++b)
      if (linked(graph, a, b, agents)) out[a].push_back(b);
  return out;
}

std::size_t diameter(Graph graph, std::size_t agents) {
  if (agents < 2) return 0;
  switch (graph) {
    case Graph::complete:
      return 1;
    case Graph::ring:
      return agents / 2;
    case Graph::line:
      return agents - 1;
    case Graph::star:
      return agents > 2 ? 2 : 1;
  }
  return 0;
}

std::size_t round_limit(const Instance& instance, Graph graph, std::uint32_t bundle_limit) {
  const std::size_t agents = instance.fleet.size(), tasks = instance.tasks.tasks.size();
  const std::size_t room = bundle_limit == 0 ? tasks : agents * bundle_limit;
  return 3 * std::min(tasks, room) * std::max<std::size_t>(1, diameter(graph, agents)) + 50;
}

std::vector<AgentId> RoundsWorld::roster() const {
  std::vector<AgentId> roster;
  for (const Uav& uav : instance.fleet) roster.push_back(uav.id);
  return roster;
}

RoundsOutcome run_rounds(const Instance& instance, const AuctionSettings& settings, Graph graph,
                         Encoding encoding) {
  const StraightTransit transit;
  const RoundsWorld world{instance, settings, transit, neighbours(graph, instance.fleet.size()),
                          encoding};
  const auto protocol = protocol_of(world);
  const std::size_t limit = round_limit(instance, graph, settings.bundle_limit);
  const std::size_t quiet = 2 * diameter(graph, instance.fleet.size()) + 2;
  RoundsOutcome outcome;
  Traffic traffic, until_change;
  for (std::size_t round = 1; round <= limit && !outcome.converged; ++round) {
    if (protocol->play(traffic)) {
      outcome.last_change_round = round;
      until_change = traffic;
    }
    if (outcome.proof_round == 0 && protocol->proven()) {
      outcome.proof_round = round;
      until_change = traffic;
    }
    outcome.converged = outcome.proof_round > 0 || round - outcome.last_change_round >= quiet;
  }
  outcome.stops = protocol->paths();
  for (const auto& stops : outcome.stops) {
    auto& path = outcome.paths.emplace_back();
    for (const PathStop& stop : stops) path.push_back(stop.task);
  }
  outcome.agreed = protocol->agreed();
  outcome.messages = until_change.messages;
  outcome.sends = until_change.sends;
  outcome.bytes = until_change.bytes;
  outcome.difference_bytes = until_change.difference_bytes;
  outcome.order_bytes = until_change.order_bytes;
  return outcome;
}

}  // namespace arcbid
