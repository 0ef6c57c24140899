// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/replay/counterfactual.hpp"

#include <algorithm>

#include "core/auction/agent.hpp"
#include "core/route/make_transit.hpp"

namespace arcbid {
namespace {

/// What a statement says of the agent's own bid for a task.
std::optional<double> own_bid(const StatementBody& body, AgentId self, TaskId task) {
  if (const auto* claims = std::get_if<Claims>(&body)) {
    for (const Claim& claim : claims->bundle)
      if (claim.task == task) return claim.bid;
    return std::nullopt;
  }
  const Belief& belief = std::get<Table>(body).beliefs.at(task.value);
  return belief.winner == self ? std::optional(belief.bid) : std::nullopt;
}

const Statement* statement_in(const Event& event) {
  if (const auto* bid = std::get_if<BidMessage>(&event.what)) return &bid->statement;
  if (const auto* relay = std::get_if<RelayMessage>(&event.what)) return &relay->statement;
  return nullptr;
}

class OnceMore {
 public:
  OnceMore(const LifeLog& log, const Explanation& drop)
      : log_(log),
        drop_(drop),
        agent_(log.birth()->agent, log.birth()->incarnation, log.mission(),
               make_transit(*log.mission()), log.birth()->now_ns) {
    out_.message = drop.source->id;
    out_.dropped_ns = log.marks()[drop.mark].t_ns;
  }

  WithoutMessage run() {
    log_.steps([this](std::size_t mark, Step step, std::string_view) {
      take(mark, step);
      return true;
    });
    return std::move(out_);
  }

 private:
  void take(std::size_t mark, const Step& step) {
    const bool is_it = log_.marks()[mark].heard == out_.message;
    if (is_it && !missing_) missing_ = *statement_in(step.event);
    if (missing_) out_.bids_logged += step.update.bids.size();
    if (is_it) {
      ++out_.copies;
      return;
    }
    const Update update = agent_.step(step.event);
    if (!missing_) return;
    out_.bids += update.bids.size();
    note_news(mark, step.event, update);
    if (update.decision && !out_.dropped_late) note(mark, *update.decision);
  }
  void note_news(std::size_t mark, const Event& event, const Update& update) {
    const Statement* said = statement_in(event);
    if (out_.instead || !said || update.refused || said->agent != missing_->agent ||
        said->key < missing_->key)
      return;
    out_.instead =
        Source{*log_.marks()[mark].heard, std::holds_alternative<RelayMessage>(event.what)};
    out_.instead_ns = log_.marks()[mark].t_ns;
  }
  void note(std::size_t mark, const DecisionMade& made) {
    const TimeNs t_ns = log_.marks()[mark].t_ns;
    const auto bid = own_bid(made.body, log_.agent(), drop_.task);
    out_.decisions.push_back({t_ns, made.round, bid.has_value(), bid.value_or(0)});
    if (!bid && mark >= drop_.mark) out_.dropped_late = t_ns;
  }

  const LifeLog& log_;
  const Explanation& drop_;
  Agent agent_;
  std::optional<Statement> missing_;
  WithoutMessage out_;
};

}  // namespace

std::optional<WithoutMessage> without_message(const RunArchive& run, const Explanation& drop) {
  if (!drop.source) return std::nullopt;
  const LifeLog& life = run.lives.at(drop.life);
  life.schemas().demand_own();
  return OnceMore(life, drop).run();
}

const Explanation* decisive_drop(const std::vector<Explanation>& story) {
  if (story.empty() || story.back().kind != Explanation::Kind::owner) return nullptr;
  for (auto told = story.rbegin(); told != story.rend(); ++told) {
    const bool dropped =
        told->kind == Explanation::Kind::outbid || told->kind == Explanation::Kind::released;
    if (dropped && told->agent != story.back().agent) return &*told;
  }
  return nullptr;
}

const Explanation* decisive_death(const std::vector<Explanation>& story) {
  const auto last = std::find_if(story.rbegin(), story.rend(), [](const Explanation& told) {
    return told.kind == Explanation::Kind::death;
  });
  return last == story.rend() ? nullptr : &*last;
}

}  // namespace arcbid
