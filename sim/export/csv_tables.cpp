// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/export/csv_tables.hpp"

#include <array>

namespace arcbid {
namespace {

std::optional<std::uint32_t> number(const std::optional<AgentId>& agent) {
  return agent ? std::optional(agent->value) : std::nullopt;
}

/// "12 7r 3": tasks in flying order, r: from its end to its beginning.
std::string words(const std::vector<PathStop>& path) {
  std::string out;
  for (const PathStop& stop : path)
    out += fmt::format("{}{}{}", out.empty() ? "" : " ", stop.task.value, stop.reversed ? "r" : "");
  return out;
}

}  // namespace

StepTables::StepTables(const RunArchive& run, const std::filesystem::path& folder)
    : run_(run),
      decisions_(folder / "decisions.csv",
                 "t_s,agent,life,record,round,changed,incarnation,version,tasks,path"),
      bids_(folder / "bids.csv", "t_s,agent,round,task,arc,bid,position"),
      messages_(folder / "messages.csv",
                "t_s,direction,agent,peer,kind,incarnation,sequence,refused"),
      events_(folder / "events.csv", "t_s,agent,life,event,detail") {}

void StepTables::take(const RunStep& at) {
  take_decision(at);
  take_bids(at);
  take_messages(at);
  take_events(at);
}

void StepTables::take_decision(const RunStep& at) {
  const auto& made = at.step.update.decision;
  if (!made) return;
  decisions_.row(seconds(at.t_ns), at.life.agent().value, at.life.incarnation(), at.mark.seq,
                 made->round, made->changed ? 1 : 0, made->key.incarnation, made->key.version,
                 made->path.size(), words(made->path));
}

void StepTables::take_bids(const RunStep& at) {
  const auto stated = statements_.stated_in(at);
  if (!stated) return;
  const auto& tasks = run_.tasks.tasks;
  for (const auto& [task, bid, position] : *stated) {
    const bool known = task.value < tasks.size();  // a damaged record may say anything
    bids_.row(seconds(at.t_ns), at.life.agent().value, at.mark.round, task.value,
              known ? std::optional(tasks[task.value].arc.value) : std::nullopt, bid, position);
  }
}

void StepTables::take_messages(const RunStep& at) {
  const std::uint32_t agent = at.life.agent().value;
  if (at.mark.heard) {
    constexpr std::array<std::string_view, 5> kinds{"", "bid", "relay", "status", ""};
    const MessageId& heard = *at.mark.heard;
    messages_.row(seconds(at.t_ns), "heard", agent, heard.sender.value,
                  kinds[at.step.event.what.index()], heard.incarnation, heard.sequence,
                  at.step.update.refused.value_or(""));
  }
  const auto sent = [&](std::string_view kind, const auto& messages) {
    for (const auto& message : messages)
      messages_.row(seconds(at.t_ns), "sent", agent, "", kind, message.header.incarnation,
                    message.header.sequence, "");
  };
  sent("bid", at.step.update.bids);
  sent("relay", at.step.update.relays);
  sent("status", at.step.update.statuses);
}

void StepTables::take_events(const RunStep& at) {
  for (const Happening& happening : happenings(at.step.update))
    events_.row(seconds(at.t_ns), at.life.agent().value, at.life.incarnation(), happening.what,
                happening.detail);
}

void StepTables::close() {
  for (CsvFile* file : {&decisions_, &bids_, &messages_, &events_}) file->close();
}

void write_owners(const RunArchive& run, const Playback& playback,
                  const std::filesystem::path& file) {
  CsvFile csv(file, "t_s,task,arc,from_owner,to_owner,bid");
  std::vector<Belief> before(run.tasks.tasks.size());
  for (const Ownership& now : ownerships(run, playback)) {
    for (const Task& task : run.tasks.tasks) {
      const Belief &was = before[task.id.value], &is = now.owners[task.id.value];
      if (was == is) continue;
      csv.row(seconds(now.t_ns), task.id.value, task.arc.value, number(was.winner),
              number(is.winner), is.winner ? std::optional(is.bid) : std::nullopt);
    }
    before = now.owners;
  }
  csv.close();
}

void write_routes(const RunArchive& run, const std::filesystem::path& file) {
  CsvFile csv(file,
              "agent,life,view,leg,kind,arc,from_m,to_m,waypoint,flown_m,flight_s,x_m,y_m,z_m,"
              "look_x,look_y,look_z");
  for (const LifeLog& life : run.lives)
    for (const auto& [view, route] : life.routes()) {
      const double speed = route.time_s > 0 ? route.length_m / route.time_s : 1;
      double flown_m = 0;
      for (std::size_t l = 0; l < route.legs.size(); ++l) {
        const RouteLeg& leg = route.legs[l];
        for (std::size_t w = 0; w < leg.waypoints.size(); ++w) {
          const auto& [at, look] = leg.waypoints[w];
          if (w > 0) flown_m += (at - leg.waypoints[w - 1].position_m).norm();
          csv.row(life.agent().value, life.incarnation(), fmt::format("{:016x}", view), l,
                  leg.arc ? "arc" : "transit",
                  leg.arc ? std::optional(leg.arc->value) : std::nullopt,
                  leg.arc ? std::optional(leg.from_m) : std::nullopt,
                  leg.arc ? std::optional(leg.to_m) : std::nullopt, w, flown_m, flown_m / speed,
                  at.x(), at.y(), at.z(), look.x(), look.y(), look.z());
        }
      }
    }
  csv.close();
}

}  // namespace arcbid
