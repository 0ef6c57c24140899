// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/replay/explain.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/auction/bundle.hpp"
#include "sim/replay/explain_text.hpp"
#include "sim/replay/mind.hpp"
#include "sim/replay/run_exchanges.hpp"

namespace arcbid {

/// Goes through all decisions once, in causal order, and tells each task's story.
class Narrator {
 public:
  Narrator(const RunArchive& run, Explainer& out)
      : run_(run), out_(out), next_(run.lives.size()), place_(run.tasks.tasks.size()) {
    for (std::size_t l = 0; l < run.lives.size(); ++l) minds_.emplace_back(run, out.index_, l);
  }

  void tell(const Moment& moment) {
    const Mark& mark = run_.lives[moment.life].marks()[moment.mark];
    if (mark.died) tell_deaths(moment);
    if (!mark.changed) return;
    Mind& mind = minds_[moment.life];
    const RunIndex::Decision& decision =
        out_.index_.decisions(moment.life)[next_[moment.life].decision++];
    mind.decide(decision);
    tell_drops(moment, decision, mind);
    tell_bids(moment, decision, mind);
  }

  /// The living are those whom nobody's tombstone names.
  std::vector<Belief> owners() const {
    std::vector<Belief> best(run_.tasks.tasks.size());
    for (std::size_t l = 0; l < minds_.size(); ++l) {
      const StatementBody* said = minds_[l].said();
      if (!said || is_over(l)) continue;
      if (const auto* table = std::get_if<Table>(said)) return table->beliefs;
      for (const Claim& claim : std::get<Claims>(*said).bundle)
        if (beats(claim.bid, run_.lives[l].agent(), best[claim.task.value]))
          best[claim.task.value] = {run_.lives[l].agent(), claim.bid};
    }
    return best;
  }

 private:
  struct Next {
    std::size_t decision = 0, notice = 0;
  };

  Explanation event(const Moment& moment, TaskId task, Explanation::Kind kind) const {
    Explanation out;
    out.t_ns = moment.t_ns;
    out.agent = run_.lives[moment.life].agent();
    out.kind = kind;
    out.task = task;
    out.life = moment.life;
    out.mark = moment.mark;
    out.round = run_.lives[moment.life].marks()[moment.mark].round;
    return out;
  }
  void add(Explanation told, const Reason& reason) {
    told.text = text_of(told, reason);
    out_.by_task_[told.task.value].push_back(std::move(told));
  }
  std::optional<Source> source(std::size_t life, std::optional<std::size_t> mark) const {
    if (!mark) return std::nullopt;
    const Mark& at = run_.lives[life].marks()[*mark];
    if (!at.heard) return std::nullopt;
    return Source{*at.heard, at.event == 2};
  }

  void tell_deaths(const Moment& moment) {
    const auto& notices = out_.index_.notices(moment.life);
    std::size_t& at = next_[moment.life].notice;
    while (at < notices.size() && notices[at].mark <= moment.mark) {
      const RunIndex::Notice& notice = notices[at++];
      if (notice.returned) continue;
      for (const TaskId task : minds_[moment.life].tasks_of(notice.agent, moment.mark)) {
        Explanation told = event(moment, task, Explanation::Kind::death);
        told.rival.winner = notice.agent;
        told.source = source(moment.life, moment.mark);
        add(std::move(told), {});
      }
    }
  }

  void tell_bids(const Moment& moment, const RunIndex::Decision& decision, const Mind& mind) {
    note_places(mind.before());
    for (std::size_t n = 0; n < mind.after().size(); ++n) {
      const Claim& claim = mind.after()[n];
      const std::size_t was = place_[claim.task.value];
      Reason reason;
      if (was > 0) reason.bid_before = mind.before()[was - 1].bid;
      if (was == n + 1 && reason.bid_before == claim.bid) continue;
      Explanation told = event(moment, claim.task, Explanation::Kind::bid);
      told.round = decision.round;
      told.place = n + 1;
      told.bid = claim.bid;
      told.rival = mind.rivals()[claim.task.value];
      add(std::move(told), reason);
    }
    forget_places(mind.before());
  }

  void tell_drops(const Moment& moment, const RunIndex::Decision& decision, const Mind& mind) {
    note_places(mind.after());
    std::optional<Reason> why;  // the same for all that nobody took
    for (std::size_t n = 0; n < mind.before().size(); ++n) {
      const Claim& claim = mind.before()[n];
      if (place_[claim.task.value] > 0) continue;
      const auto loss = mind.loss(claim);
      Explanation told =
          event(moment, claim.task, loss ? Explanation::Kind::outbid : Explanation::Kind::released);
      told.round = decision.round;
      told.place = n + 1;
      told.bid = claim.bid;
      if (loss) {
        told.rival = loss->winner;
        told.source = source(moment.life, loss->mark);
        told.row = loss->row;
        add(std::move(told), {.rule = loss->rule});
        continue;
      }
      if (!why) why = reason_of_release(moment.life, mind);
      told.rival = mind.rivals()[claim.task.value];
      told.source = why->source;
      add(std::move(told), *why);
    }
    forget_places(mind.after());
  }

  /// The first place at which the bundles part: something was taken there, or became free.
  Reason reason_of_release(std::size_t life, const Mind& mind) const {
    const bool is_table = mind.said() && std::holds_alternative<Table>(*mind.said());
    for (std::size_t p = 0; p < mind.before().size(); ++p) {
      const Claim& old = mind.before()[p];
      const bool same = p < mind.after().size() && mind.after()[p] == old;
      if (const auto loss = same ? std::nullopt : mind.loss(old))
        return {.rule = loss->rule,
                .cause = Reason::Cause::earlier_lost,
                .other = old.task,
                .place = p + 1,
                .by = loss->winner.winner,
                .source = source(life, loss->mark)};
      if (!same && !is_table && p < mind.after().size())
        return freed(life, mind, mind.after()[p].task, p + 1);
    }
    return {};
  }
  Reason freed(std::size_t life, const Mind& mind, TaskId task, std::size_t place) const {
    Reason out{.cause = Reason::Cause::came_free, .other = task, .place = place};
    out.by = mind.rivals_before()[task.value].winner;
    const Learnt* news = out.by ? mind.news_of(*out.by) : nullptr;
    if (news && news->key.dead) out.cause = Reason::Cause::death;
    if (news) out.source = source(life, news->mark);
    return out;
  }

  bool is_over(std::size_t life) const {
    const LifeLog& log = run_.lives[life];
    const std::uint64_t incarnation = log.incarnation();
    for (std::size_t l = 0; l < minds_.size(); ++l) {
      if (run_.lives[l].agent() == log.agent()) {
        if (run_.lives[l].incarnation() > incarnation) return true;
      } else if (minds_[l].buried(log.agent(), incarnation)) {
        return true;
      }
    }
    return false;
  }

  void note_places(const std::vector<Claim>& claims) {
    for (std::size_t n = 0; n < claims.size(); ++n) place_[claims[n].task.value] = n + 1;
  }
  void forget_places(const std::vector<Claim>& claims) {
    for (const Claim& claim : claims) place_[claim.task.value] = 0;
  }

  const RunArchive& run_;
  Explainer& out_;
  std::vector<Next> next_;
  std::vector<Mind> minds_;
  std::vector<std::size_t> place_;  // by task, from 1: in one bundle, while it is looked at
};

Explainer::Explainer(const RunArchive& run, const Playback& playback)
    : index_(run), by_task_(run.tasks.tasks.size()) {
  Narrator narrator(run, *this);
  for (const Moment& moment : playback.moments()) narrator.tell(moment);
  owners_ = narrator.owners();
  const TimeNs end_ns = playback.moments().empty() ? 0 : playback.moments().back().t_ns;
  tell_owners(end_ns);
  tell_exchanges(run, playback, end_ns);
}

void Explainer::tell_owners(TimeNs end_ns) {
  for (std::uint32_t j = 0; j < owners_.size(); ++j) {
    if (!owners_[j].winner) continue;
    Explanation last;
    last.t_ns = end_ns;
    last.agent = *owners_[j].winner;
    last.kind = Explanation::Kind::owner;
    last.task = {j};
    last.bid = owners_[j].bid;
    for (const Explanation& told : by_task_[j])
      if (told.kind == Explanation::Kind::outbid && told.agent != last.agent)
        last.rival = {told.agent, told.bid};
    last.text = text_of(last, {});
    by_task_[j].push_back(std::move(last));
  }
}

void Explainer::tell_exchanges(const RunArchive& run, const Playback& playback, TimeNs end_ns) {
  const std::optional<Agreement> agreement = last_agreement(run, playback);
  if (!agreement) return;
  RunExchanges exchanges(run);
  const std::vector<AgentId>* flown_by = exchanges.owners(*agreement);
  if (!flown_by) return;
  for (std::uint32_t j = 0; j < flown_by->size(); ++j) {
    const Belief& won = agreement->winners[j];
    if (!won.winner || won.winner == (*flown_by)[j]) continue;
    Explanation told;
    told.t_ns = end_ns;
    told.agent = (*flown_by)[j];
    told.kind = Explanation::Kind::exchanged;
    told.task = {j};
    told.bid = won.bid;
    told.rival = won;
    told.text = text_of(told, {});
    by_task_[j].push_back(std::move(told));
  }
}

std::vector<Explanation> Explainer::explain(AgentId agent) const {
  std::vector<Explanation> out;
  for (const auto& task : by_task_)
    for (const Explanation& told : task)
      if (told.agent == agent) out.push_back(told);
  std::stable_sort(out.begin(), out.end(), [](const Explanation& a, const Explanation& b) {
    return std::tuple(a.t_ns, a.mark) < std::tuple(b.t_ns, b.mark);
  });
  return out;
}

std::vector<Explanation> explain(const RunArchive& run, const Playback& playback, TaskId task) {
  return Explainer(run, playback).explain(task);
}

}  // namespace arcbid
