// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/commands/explain_report.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/base/error.hpp"

namespace arcbid {
namespace {

using Json = nlohmann::json;

double seconds(TimeNs t_ns) {
  return static_cast<double>(t_ns) * 1e-9;
}
Json id_of(const MessageId& id) {
  return {{"sender", id.sender.value}, {"incarnation", id.incarnation}, {"sequence", id.sequence}};
}
Json as_json(const Explanation& told) {
  Json out{{"t_ns", told.t_ns},   {"agent", told.agent.value}, {"kind", name_of(told.kind)},
           {"round", told.round}, {"text", told.text},         {"task", told.task.value}};
  if (told.kind != Explanation::Kind::death) out["bid"] = told.bid;
  if (told.place > 0) out["place"] = told.place;
  if (told.rival.winner)
    out["rival"] = {{"agent", told.rival.winner->value}, {"bid", told.rival.bid}};
  if (told.rival.winner && told.kind != Explanation::Kind::death)
    out["margin"] = std::abs(told.bid - told.rival.bid);
  if (told.source) {
    out["message"] = id_of(told.source->id);
    out["message"]["kind"] = told.source->is_relay ? "relay" : "bid";
  }
  if (told.row > 0) out["row"] = told.row;
  return out;
}
std::string owner_in(const WorldResult& world, TaskId task) {
  const bool known = task.value < world.winners.size() && world.winners[task.value].winner;
  return known ? fmt::format("agent {}", world.winners[task.value].winner->value) : "nobody";
}

}  // namespace

ExplainReport::ExplainReport(const RunArchive& run)
    : run_(run),
      playback_(run),
      explainer_(run, playback_),
      json_{{"run", run.directory.string()}, {"tasks", Json::array()}, {"agents", Json::array()}} {}

template <class... T>
void ExplainReport::line(fmt::format_string<T...> format, T&&... values) {
  text_ += fmt::format(format, std::forward<T>(values)...) + '\n';
}

void ExplainReport::add(TaskId id) {
  const Task& task = run_.tasks.tasks[id.value];
  const std::vector<Explanation>& story = explainer_.explain(id);
  line("task {}: arc {} from {:.2f} m to {:.2f} m", id.value, task.arc.value, task.from_m,
       task.to_m);
  Json out{{"task", id.value},  {"arc", task.arc.value}, {"from_m", task.from_m},
           {"to_m", task.to_m}, {"owner", nullptr},      {"story", Json::array()}};
  for (const Explanation& told : story) {
    line("  {:>10.6f} s  agent {}: {}", seconds(told.t_ns), told.agent.value, told.text);
    out["story"].push_back(as_json(told));
    if (told.kind == Explanation::Kind::owner) out["owner"] = told.agent.value;
  }
  if (story.empty()) line("  nobody ever bid for it");
  if (const Explanation* drop = decisive_drop(story); drop && drop->source)
    out["without_message"] = tell_without(*drop);
  if (const Explanation* death = decisive_death(story))
    out["with_agent_alive"] = tell(*death, alive(*death));
  json_["tasks"].push_back(std::move(out));
}

Json ExplainReport::tell_without(const Explanation& drop) {
  try {
    const WithoutMessage other = without_message(run_, drop).value();
    line("  without {}, which made agent {} drop it in round {}:", describe(*drop.source),
         drop.agent.value, drop.round);
    return tell(other);
  } catch (const InputError& error) {
    line("  without {}: cannot be told: {}", describe(*drop.source), error.what());
    return {{"message", id_of(drop.source->id)}, {"problem", error.what()}};
  }
}

Json ExplainReport::tell(const WithoutMessage& other) {
  constexpr std::size_t most_shown = 3;
  Json out{{"message", id_of(other.message)},
           {"copies", other.copies},
           {"bids", other.bids},
           {"bids_logged", other.bids_logged},
           {"decisions", Json::array()}};
  for (const WithoutMessage::Decision& made : other.decisions) {
    out["decisions"].push_back({{"t_ns", made.t_ns},
                                {"round", made.round},
                                {"has_task", made.has_task},
                                {"bid", made.has_task ? Json(made.bid) : Json()}});
    if (out["decisions"].size() > most_shown) continue;
    line("    {:>8.6f} s  round {}: {}", seconds(made.t_ns), made.round,
         made.has_task ? fmt::format("has the task, for {:.3f}", made.bid) : "has it no more");
  }
  if (other.instead) {
    const double after_s = seconds(other.instead_ns - other.dropped_ns);
    line("    a statement as new came by {}, {:.6f} s {} the drop", describe(*other.instead),
         std::abs(after_s), after_s < 0 ? "before" : "after");
    out["instead"] = id_of(other.instead->id);
  }
  if (other.dropped_late) {
    line("    it would have been wrong for {:.6f} s",
         seconds(*other.dropped_late - other.dropped_ns));
    out["wrong_for_s"] = seconds(*other.dropped_late - other.dropped_ns);
  } else {
    line("    it would not have dropped the task in all that is on record");
    out["wrong_for_s"] = nullptr;
  }
  line("    bids sent from then on: {} instead of {}; the others' answers stay as they were",
       other.bids, other.bids_logged);
  return out;
}

const ExplainReport::Alive& ExplainReport::alive(const Explanation& death) {
  const auto [at, is_new] = alive_.try_emplace(*death.rival.winner);
  if (!is_new) return at->second;
  Alive& worlds = at->second;
  try {
    const LiveRun run = read_run(run_.directory);
    const WorldSpec world = world_of(run, run.seed);
    const auto other = with_alive(world, *death.rival.winner, death.t_ns);
    if (!other) {
      worlds.problem = "no crash of it is on record: it was missed for another reason";
      return worlds;
    }
    worlds.before = run_world(world);
    worlds.after = run_world(*other);
  } catch (const InputError& error) {
    worlds.problem = error.what();
  }
  return worlds;
}

Json ExplainReport::tell(const Explanation& death, const Alive& worlds) {
  const AgentId agent = *death.rival.winner;
  Json out{{"agent", agent.value}};
  if (!worlds.after) {
    line("  with agent {} alive: cannot be told: {}", agent.value, worlds.problem);
    out["problem"] = worlds.problem;
    return out;
  }
  const WorldResult &before = *worlds.before, &after = *worlds.after;
  line(
      "  with agent {} alive, simulated: {} would have it instead of {}; makespan {:.3f} s instead "
      "of {:.3f} s, {:+.3f} s; {} tasks with another owner",
      agent.value, owner_in(after, death.task), owner_in(before, death.task), after.makespan_s,
      before.makespan_s, after.makespan_s - before.makespan_s, owners_changed(before, after));
  out["owner"] = {{"before", owner_in(before, death.task)}, {"after", owner_in(after, death.task)}};
  out["makespan_s"] = {{"before", before.makespan_s},
                       {"after", after.makespan_s},
                       {"difference", after.makespan_s - before.makespan_s}};
  out["owners_changed"] = owners_changed(before, after);
  return out;
}

void ExplainReport::add(AgentId agent) {
  line("agent {}", agent.value);
  Json out{{"agent", agent.value}, {"story", Json::array()}};
  for (const Explanation& told : explainer_.explain(agent)) {
    line("  {:>10.6f} s  task {}: {}", seconds(told.t_ns), told.task.value, told.text);
    out["story"].push_back(as_json(told));
  }
  json_["agents"].push_back(std::move(out));
}

}  // namespace arcbid
