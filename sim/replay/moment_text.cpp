// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/replay/moment_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>

#include "core/base/seconds.hpp"

namespace arcbid {
namespace {

constexpr std::size_t most_named = 6;  // tasks that are named one by one

struct Heard {
  std::string operator()(const Tick& tick) const {
    return fmt::format("tick, {} peers", tick.matched_peers);
  }
  std::string operator()(const BidMessage& bid) const {
    return fmt::format("hears bid {}/{}", bid.header.sender.value, bid.header.sequence);
  }
  std::string operator()(const RelayMessage& relay) const {
    return fmt::format("hears relay {}/{} of agent {}", relay.header.sender.value,
                       relay.header.sequence, relay.statement.agent.value);
  }
  std::string operator()(const StatusMessage& status) const {
    return fmt::format("hears status {}/{}, round {}", status.header.sender.value,
                       status.header.sequence, status.round);
  }
  std::string operator()(const RoutePublished&) const { return "its route is published"; }
};

std::string outcome(const Update& update) {
  std::string out;
  const auto add = [&out](const std::string& what) { out += "; " + what; };
  if (update.refused) add(fmt::format("refuses it: {}", *update.refused));
  for (const AgentId dead : update.died) add(fmt::format("agent {} is dead", dead.value));
  for (const AgentId back : update.returned) add(fmt::format("agent {} is back", back.value));
  if (update.started) add("the auction starts");
  if (update.agreement_lost) add("the agreement is void");
  if (const auto& made = update.decision)
    add(fmt::format("round {}: {}, {} tasks", made->round,
                    made->changed ? "decides anew" : "stays with what it has", made->path.size()));
  if (update.agreed) add(fmt::format("agreement {:016x} is proven", update.agreed->view_hash));
  const std::size_t bids = update.bids.size(), relays = update.relays.size(),
                    statuses = update.statuses.size();
  if (bids + relays + statuses > 0)
    add(fmt::format("says {} bids, {} relays, {} statuses", bids, relays, statuses));
  return out;
}

std::string name_of(const std::optional<AgentId>& agent) {
  return agent ? fmt::format("agent {}", agent->value) : "nobody";
}

/// Tasks whose owner changed, together where they went the same way.
std::vector<std::string> changes(const std::vector<Belief>& before,
                                 const std::vector<Belief>& after) {
  std::map<std::pair<std::optional<AgentId>, std::optional<AgentId>>, std::vector<std::size_t>>
      ways;
  for (std::size_t j = 0; j < after.size(); ++j)
    if (before[j].winner != after[j].winner) ways[{before[j].winner, after[j].winner}].push_back(j);
  std::vector<std::string> out;
  for (auto& [way, tasks] : ways) {
    const std::size_t all = tasks.size();
    if (all > most_named) tasks.resize(most_named);
    out.push_back(fmt::format("{:>14}{} -> {}: {} tasks: {}{}", "", name_of(way.first),
                              name_of(way.second), all, fmt::join(tasks, ", "),
                              all > most_named ? ", ..." : ""));
  }
  return out;
}

/// Whom any of the living holds to be dead.
std::vector<std::uint32_t> buried(const RunArchive& run,
                                  const std::vector<Playback::AgentState>& states) {
  std::vector<std::uint32_t> out;
  for (std::size_t k = 0; k < states.size(); ++k)
    for (const Playback::AgentState& by : states) {
      if (!by.life || by.state == Playback::State::dead) continue;
      const auto& learnt = run.lives[*by.life].learnt()[k];
      const auto after =
          std::lower_bound(learnt.begin(), learnt.end(), by.steps,
                           [](const Learnt& l, std::size_t steps) { return l.mark < steps; });
      if (after == learnt.begin() || !std::prev(after)->key.dead) continue;
      out.push_back(run.mission->fleet[k].id.value);
      break;
    }
  return out;
}

}  // namespace

std::string_view name_of(Playback::State state) {
  constexpr std::array<std::string_view, 7> names{"unborn", "waiting", "bidding", "agreed",
                                                  "routed", "dead",    "ended"};
  return names[static_cast<std::size_t>(state)];
}

std::vector<std::string> text_of(const RunArchive& run, const Playback& playback,
                                 std::size_t moment) {
  const Moment& at = playback.moments()[moment];
  const LifeLog& log = run.lives[at.life];
  const Step step = log.step(at.mark);
  std::vector<std::string> out{fmt::format("{:>12.6f} s  agent {}: {}{}", seconds(at.t_ns),
                                           log.agent().value, std::visit(Heard{}, step.event.what),
                                           outcome(step.update))};
  const Mark& mark = log.marks()[at.mark];
  if (!mark.changed && !mark.died && !mark.returned) return out;
  for (std::string& line : changes(playback.owners(moment), playback.owners(moment + 1)))
    out.push_back(std::move(line));
  return out;
}

std::string status_of(const RunArchive& run, const Playback& playback, std::size_t moments) {
  const auto states = playback.agents(moments);
  const std::vector<Belief> owners = playback.owners(moments);
  std::vector<std::size_t> tasks(states.size(), 0);
  const std::vector<std::uint32_t> dead = buried(run, states);
  std::size_t owned = 0;
  for (const Belief& owner : owners)
    for (std::size_t k = 0; k < states.size(); ++k)
      if (owner.winner == run.mission->fleet[k].id) ++tasks[k], ++owned;
  std::string out = fmt::format(
      "[{:.6f} s, moment {} of {}] mission {:016x}: {} arcs, {} tasks, {} owned; dead: {};",
      moments == 0 ? 0 : seconds(playback.moments()[moments - 1].t_ns), moments,
      playback.moments().size(), run.mission->id, run.mission->arcs.size(), owners.size(), owned,
      dead.empty() ? "nobody" : fmt::format("{}", fmt::join(dead, " ")));
  for (std::size_t k = 0; k < states.size(); ++k)
    out += fmt::format(" {}:{} r{} {}{}", run.mission->fleet[k].id.value, name_of(states[k].state),
                       states[k].round, tasks[k], k + 1 < states.size() ? "," : "");
  return out;
}

}  // namespace arcbid
