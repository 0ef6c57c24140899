// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "sim/replay/run_exchanges.hpp"
#include "sim/view/view_data.hpp"

namespace arcbid {
namespace {

using nlohmann::json;

json number_of(const std::optional<AgentId>& agent) {
  return agent ? json(agent->value) : json(-1);
}

/// z and y of one agent, as they change with what its life comes to hold, and with the exchanges
/// after what it agreed on, from its route on. A new life knows nothing.
class Beliefs {
 public:
  Beliefs(const RunArchive& run, RunExchanges& exchanges)
      : run_(run),
        exchanges_(exchanges),
        known_(run.tasks.tasks.size()),
        view_(roster(*run.mission)) {}

  void live(const LifeLog& life) {
    view_ = View(roster(*run_.mission));
    note(life.born_ns(), 0, std::vector<Belief>(known_.size()));
    std::map<std::size_t, std::vector<std::pair<std::size_t, Learnt>>> news;  // by mark
    for (std::size_t k = 0; k < run_.mission->fleet.size(); ++k)
      for (const Learnt& learnt : life.learnt()[k]) news[learnt.mark].emplace_back(k, learnt);
    std::optional<Agreement> agreed;
    life.steps([&](std::size_t mark, const Step& step, std::string_view) {
      if (step.update.agreed) agreed = step.update.agreed;
      if (std::holds_alternative<RoutePublished>(step.event.what) && agreed)
        note(life.marks()[mark].t_ns, life.marks()[mark].round, exchanged(*agreed));
      const auto learnt = news.find(mark);
      if (learnt == news.end()) return true;
      for (const auto& [member, what] : learnt->second) merge(member, what, step);
      note(life.marks()[mark].t_ns, life.marks()[mark].round, now(step));
      return true;
    });
  }
  json changes() const { return changes_; }

 private:
  static std::vector<AgentId> roster(const Mission& mission) {
    std::vector<AgentId> out;
    for (const Uav& uav : mission.fleet) out.push_back(uav.id);
    return out;
  }
  void merge(std::size_t member, const Learnt& learnt, const Step& step) {
    const AgentId of = run_.mission->fleet[member].id;
    if (learnt.key.dead)
      view_.merge({of, learnt.key, Claims{}});
    else if (learnt.is_own && step.update.decision && step.update.decision->key == learnt.key)
      view_.merge({of, learnt.key, step.update.decision->body});
    else if (learnt.is_own) {
      for (const BidMessage& bid : step.update.bids)
        if (bid.statement.key == learnt.key) view_.merge(bid.statement);
    } else if (const auto* bid = std::get_if<BidMessage>(&step.event.what))
      view_.merge(bid->statement);
    else if (const auto* relay = std::get_if<RelayMessage>(&step.event.what))
      view_.merge(relay->statement);
  }
  std::vector<Belief> exchanged(const Agreement& agreement) {
    std::vector<Belief> flown = known_;
    if (const auto* owners = exchanges_.owners(agreement))
      for (std::size_t j = 0; j < flown.size(); ++j)
        if (flown[j].winner) flown[j].winner = (*owners)[j];
    return flown;
  }
  std::vector<Belief> now(const Step& step) const {
    if (states_claims(run_.mission->auction.policy)) return best_claims(view_, known_.size());
    const auto* table =
        step.update.decision ? std::get_if<Table>(&step.update.decision->body) : nullptr;
    return table && table->beliefs.size() == known_.size() ? table->beliefs : known_;
  }
  void note(TimeNs t_ns, std::uint32_t round, std::vector<Belief> now) {
    json z = json::array();
    for (std::size_t j = 0; j < now.size(); ++j) {
      if (now[j] == known_[j]) continue;
      z.push_back(j);
      z.push_back(number_of(now[j].winner));
      z.push_back(now[j].winner ? json(now[j].bid) : json(nullptr));
    }
    known_ = std::move(now);
    if (!z.empty())
      changes_.push_back({{"t_s", seconds(t_ns)}, {"round", round}, {"z", std::move(z)}});
  }

  const RunArchive& run_;
  RunExchanges& exchanges_;
  std::vector<Belief> known_;
  View view_;
  json changes_ = json::array();
};

/// One after another; of two that lived at once (a second process with the id) the first.
json views_of(const RunArchive& run) {
  json views = json::array();
  RunExchanges exchanges(run);
  for (std::size_t l = 0; l < run.lives.size();) {
    const AgentId agent = run.lives[l].agent();
    Beliefs beliefs(run, exchanges);
    TimeNs until_ns = INT64_MIN;
    for (; l < run.lives.size() && run.lives[l].agent() == agent; ++l) {
      if (run.lives[l].born_ns() < until_ns) continue;
      until_ns = run.lives[l].last_ns();
      beliefs.live(run.lives[l]);
    }
    views.push_back({{"agent", agent.value}, {"changes", beliefs.changes()}});
  }
  return views;
}

/// What agents claim of themselves, decision by decision, and when two first claim the same.
class Story {
 public:
  Story(const RunArchive& run, const Playback& playback) : run_(run), playback_(playback) {}

  json decisions = json::array(), states = json::array(), events = json::array();

  void tell() {
    for (const auto& [life, mark, t_ns] : playback_.moments()) {
      const LifeLog& log = run_.lives[life];
      const Mark& m = log.marks()[mark];
      if (begun_.insert(life).second) state(t_ns, log.agent(), "waiting");
      if (!m.decided && !m.started && !m.lost && !m.agreed && !m.died && !m.returned &&
          !m.refused && m.event != route_published)
        continue;
      tell(t_ns, log, log.step(mark));
    }
    for (const LifeLog& log : run_.lives) tell_end(log);
    tell_faults();
    const auto earlier = [](const json& a, const json& b) { return a["t_s"] < b["t_s"]; };
    std::stable_sort(events.begin(), events.end(), earlier);
    std::stable_sort(states.begin(), states.end(), earlier);
  }

 private:
  static constexpr std::uint8_t route_published = 4;  // index of Event::what

  void event(TimeNs t_ns, const char* kind, std::optional<AgentId> agent, const std::string& text) {
    events.push_back({{"t_s", seconds(t_ns)},
                      {"kind", kind},
                      {"agent", agent ? json(agent->value) : json(nullptr)},
                      {"text", text}});
  }
  void state(TimeNs t_ns, AgentId agent, const char* name) {
    states.push_back({{"t_s", seconds(t_ns)}, {"agent", agent.value}, {"state", name}});
  }
  void tell(TimeNs t_ns, const LifeLog& log, const Step& step) {
    const AgentId id = log.agent();
    const Update& u = step.update;
    if (u.started) {
      state(t_ns, id, "bidding");
      event(t_ns, "start", id, fmt::format("agent {} begins to bid", id.value));
    }
    for (const AgentId dead : u.died) {
      event(t_ns, "death", dead, fmt::format("agent {} declares {} dead", id.value, dead.value));
      claims_.erase(dead);
    }
    for (const AgentId back : u.returned)
      event(t_ns, "return", back, fmt::format("agent {} sees {} return", id.value, back.value));
    if (u.agreement_lost) {
      state(t_ns, id, "bidding");
      event(t_ns, "reopened", id, fmt::format("agent {} bids again", id.value));
    }
    if (u.refused)
      event(t_ns, "refused", id, fmt::format("agent {} refuses: {}", id.value, *u.refused));
    if (u.decision) decide(t_ns, id, *u.decision);
    if (u.agreed) {
      state(t_ns, id, "agreed");
      event(t_ns, "agreement", id,
            fmt::format("agent {} holds the proof, round {}", id.value, u.agreed->round));
    }
    if (step.event.what.index() == route_published) {
      state(t_ns, id, "routed");
      event(t_ns, "route", id, fmt::format("agent {} published its route", id.value));
    }
  }
  void decide(TimeNs t_ns, AgentId id, const DecisionMade& decision) {
    json bundle = json::array();
    std::vector<std::uint32_t> tasks;
    const auto claim = [&](std::uint32_t task, double bid) {
      tasks.push_back(task);
      bundle.push_back(task);
      bundle.push_back(bid);
    };
    if (const auto* claims = std::get_if<Claims>(&decision.body)) {
      for (const Claim& c : claims->bundle) claim(c.task.value, c.bid);
    } else {
      const auto& beliefs = std::get<Table>(decision.body).beliefs;
      for (std::uint32_t j = 0; j < beliefs.size(); ++j)
        if (beliefs[j].winner == id) claim(j, beliefs[j].bid);
    }
    decisions.push_back({{"t_s", seconds(t_ns)},
                         {"agent", id.value},
                         {"round", decision.round},
                         {"changed", decision.changed},
                         {"bundle", bundle}});
    claims_[id] = std::move(tasks);
    look_for_conflict(t_ns);
  }
  void look_for_conflict(TimeNs t_ns) {
    if (conflict_told_) return;
    std::map<std::uint32_t, AgentId> claimed;
    for (const auto& [agent, tasks] : claims_)
      for (const std::uint32_t task : tasks) {
        const auto [first, is_new] = claimed.try_emplace(task, agent);
        if (is_new) continue;
        conflict_told_ = true;
        return event(t_ns, "conflict", agent,
                     fmt::format("first conflict: agents {} and {} both claim task {}",
                                 first->second.value, agent.value, task));
      }
  }
  void tell_end(const LifeLog& log) {
    if (log.marks().empty()) return;
    if (!log.ended_by().empty()) {
      state(log.last_ns(), log.agent(), "ended");
      return event(log.last_ns(), "end", log.agent(),
                   fmt::format("agent {} ends, by {}", log.agent().value, log.ended_by()));
    }
    if (run_.is_live) return;
    state(log.last_ns(), log.agent(), "dead");
    event(log.last_ns(), "death", log.agent(),
          fmt::format("agent {} is not heard of again", log.agent().value));
  }
  void tell_faults() {
    if (!run_.result.is_object() || !run_.result.contains("faults")) return;
    for (const json& fault : run_.result["faults"])
      events.push_back({{"t_s", fault.value("time_s", 0.0)},
                        {"kind", "fault"},
                        {"agent", fault.value("agent", 0u)},
                        {"text", fault.value("fault", "")}});
  }

  const RunArchive& run_;
  const Playback& playback_;
  std::set<std::size_t> begun_;
  std::map<AgentId, std::vector<std::uint32_t>> claims_;
  bool conflict_told_ = false;
};

}  // namespace

json auction_data(const RunArchive& run, const Playback& playback) {
  Story story(run, playback);
  story.tell();
  const auto& moments = playback.moments();
  return {{"start_s", moments.empty() ? 0.0 : seconds(moments.front().t_ns)},
          {"end_s", moments.empty() ? 0.0 : seconds(moments.back().t_ns)},
          {"views", views_of(run)},
          {"decisions", story.decisions},
          {"states", story.states},
          {"events", story.events},
          {"links", links_data(run)}};
}

}  // namespace arcbid
