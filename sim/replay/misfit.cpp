// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/replay/misfit.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace arcbid {
namespace {

class Fitting {
 public:
  Fitting(const Mission& mission, std::size_t tasks) : mission_(mission), tasks_(tasks) {}

  std::optional<std::string> problem;

  void fit(TaskId task) {
    if (task.value >= tasks_) refuse("task", task.value);
  }
  void fit(AgentId agent) {
    const auto at = std::lower_bound(mission_.fleet.begin(), mission_.fleet.end(), agent,
                                     [](const Uav& uav, AgentId id) { return uav.id < id; });
    if (at == mission_.fleet.end() || at->id != agent) refuse("agent", agent.value);
  }
  void fit(const Statement& statement) {
    fit(statement.agent);
    fit(statement.body);
  }
  void fit(const StatementBody& body) {
    if (const auto* claims = std::get_if<Claims>(&body)) {
      for (const Claim& claim : claims->bundle) fit(claim.task);
      return;
    }
    const Table& table = std::get<Table>(body);
    const bool by_agent = table.timestamps.size() == mission_.fleet.size();
    if (table.beliefs.size() != tasks_ || !(by_agent || table.timestamps.size() == tasks_))
      return refuse("a table of size", table.beliefs.size());
    fit(table.beliefs);
  }
  void fit(const std::vector<Belief>& beliefs) {
    for (const Belief& belief : beliefs)
      if (belief.winner) fit(*belief.winner);
  }
  void fit(const std::vector<PathStop>& path) {
    for (const PathStop& stop : path) fit(stop.task);
  }
  void fit(const Agreement& agreement) {
    if (agreement.winners.size() != tasks_) refuse("winners of", agreement.winners.size());
    fit(agreement.winners);
    fit(agreement.path);
    for (const Taken& taken : agreement.taken) {
      fit(taken.agent);
      for (const TaskId task : taken.tasks) fit(task);
    }
  }

 private:
  void refuse(const char* what, std::uint64_t value) {
    if (!problem) problem = fmt::format("{} {} is not of its mission", what, value);
  }
  const Mission& mission_;
  const std::size_t tasks_;
};

}  // namespace

std::optional<std::string> misfit(const Step& step, const Mission& mission, std::size_t tasks) {
  Fitting fitting(mission, tasks);
  const Update& update = step.update;
  if (!update.refused) {
    if (const auto* bid = std::get_if<BidMessage>(&step.event.what)) fitting.fit(bid->statement);
    if (const auto* relay = std::get_if<RelayMessage>(&step.event.what))
      fitting.fit(relay->statement);
  }
  for (const BidMessage& bid : update.bids) fitting.fit(bid.statement);
  for (const RelayMessage& relay : update.relays) fitting.fit(relay.statement);
  for (const AgentId agent : update.died) fitting.fit(agent);
  for (const AgentId agent : update.returned) fitting.fit(agent);
  if (update.decision) {
    fitting.fit(update.decision->body);
    fitting.fit(update.decision->path);
  }
  if (update.agreed) fitting.fit(*update.agreed);
  return fitting.problem;
}

}  // namespace arcbid
