// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/replay/run_events.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace arcbid {
namespace {

std::set<TaskId> tasks_of(const StatementBody& body, AgentId agent) {
  std::set<TaskId> out;
  if (const auto* claims = std::get_if<Claims>(&body)) {
    for (const Claim& claim : claims->bundle) out.insert(claim.task);
    return out;
  }
  const std::vector<Belief>& beliefs = std::get<Table>(body).beliefs;
  for (std::uint32_t j = 0; j < beliefs.size(); ++j)
    if (beliefs[j].winner == agent) out.insert({j});
  return out;
}

class Finder {
 public:
  explicit Finder(const RunArchive& run) : run_(run), own_(run.lives.size()) {}

  void take(const Moment& moment, std::size_t number) {
    const Mark& mark = run_.lives[moment.life].marks()[moment.mark];
    const AgentId self = run_.lives[moment.life].agent();
    number_ = number;
    if (mark.lost) note("agreement lost");
    const bool may_conflict = !has_conflict_ && (mark.changed || (mark.learnt && mark.heard));
    if (mark.died || mark.returned || may_conflict) look_into(moment, self);
    if (mark.agreed) last_agreement_ = number;
  }
  std::vector<RunEvent> found() {
    if (last_agreement_ > 0) out_.push_back({"agreement", last_agreement_});
    std::stable_sort(out_.begin(), out_.end(),
                     [](const RunEvent& a, const RunEvent& b) { return a.moments < b.moments; });
    return std::move(out_);
  }

 private:
  void note(std::string name) { out_.push_back({std::move(name), number_}); }

  void look_into(const Moment& moment, AgentId self) {
    const Step step = run_.lives[moment.life].step(moment.mark);
    for (const AgentId dead : step.update.died)
      if (gone_.insert(dead).second) note(fmt::format("agent {} died", dead.value));
    for (const AgentId back : step.update.returned)
      if (gone_.erase(back) > 0) note(fmt::format("agent {} returned", back.value));
    if (has_conflict_) return;
    if (step.update.decision) own_[moment.life] = tasks_of(step.update.decision->body, self);
    if (const auto* bid = std::get_if<BidMessage>(&step.event.what))
      hear(moment.life, bid->statement);
    if (const auto* relay = std::get_if<RelayMessage>(&step.event.what))
      hear(moment.life, relay->statement);
  }
  void hear(std::size_t life, const Statement& said) {
    for (const TaskId task : tasks_of(said.body, said.agent)) {
      if (!own_[life].contains(task)) continue;
      has_conflict_ = true;
      return note("first conflict");
    }
  }

  const RunArchive& run_;
  std::vector<std::set<TaskId>> own_;  // by life, until the first conflict
  std::set<AgentId> gone_;
  std::vector<RunEvent> out_;
  std::size_t number_ = 0, last_agreement_ = 0;
  bool has_conflict_ = false;
};

}  // namespace

std::vector<RunEvent> run_events(const RunArchive& run, const Playback& playback) {
  Finder finder(run);
  const std::vector<Moment>& moments = playback.moments();
  for (std::size_t m = 0; m < moments.size(); ++m) finder.take(moments[m], m + 1);
  std::vector<RunEvent> out = finder.found();
  out.insert(out.begin(), {"start", std::min<std::size_t>(1, moments.size())});
  out.push_back({"end", moments.size()});
  return out;
}

}  // namespace arcbid
