// SPDX-License-Identifier: GPL-3.0-or-later
// What an agent says, and when it wants to be woken.
#include <algorithm>
#include <utility>

#include "core/auction/agent.hpp"

namespace arcbid {
namespace {

constexpr TimeNs heartbeats_a_lease = 8;

}  // namespace

Header Agent::header() {
  return {self_, incarnation_, ++sequence_, expected_.mission_digest, expected_.task_digest};
}

StatusMessage Agent::status(bool whole) const {
  StatusMessage status;
  status.whole = whole;
  status.phase = phase_;
  status.round = round_;
  status.matched_peers = matched_peers_;
  if (readiness_.ready()) {
    status.view_hash = view_hash_;
    for (std::size_t k = 0; k < view_.roster().size(); ++k)
      if (readiness_.set()[k]) status.ready.push_back(view_.roster()[k]);
  }
  tell_what_is_held(status);
  return status;
}

/// A whole status names everybody; in between, what has changed since. What is said again and again
/// until the next whole one is news, so that losing one status costs little.
void Agent::tell_what_is_held(StatusMessage& status) const {
  const std::vector<Heartbeat>& heartbeats = membership_.heartbeats();
  for (std::size_t k = 0; k < view_.roster().size(); ++k) {
    const AgentId agent = view_.roster()[k];
    const bool new_life =
        status.whole || heartbeats[k].incarnation != said_heartbeats_[k].incarnation;
    if (status.whole || view_.key(k) != said_keys_[k]) status.view.push_back({agent, view_.key(k)});
    if (new_life && k != me_) status.heartbeats.push_back({agent, heartbeats[k]});
  }
}

/// A bid says by itself that a round was decided. Who had none to make says so at once; who had
/// one, when all have answered and there is nothing to decide: it is ready then.
bool Agent::round_is_reported(const Update& update) const {
  if (update.decision) return update.bids.empty();
  return !undecided_ && !round_was_told_ && round_is_over();
}

void Agent::send(Update& update) {
  for (const std::size_t author : dissemination_.due(view_, now_ns_)) {
    if (author == me_)
      update.bids.push_back({header(), view_.of(author)});
    else
      update.relays.push_back({header(), view_.of(author)});
  }
  const AuctionSettings& auction = mission_->auction;
  const TimeNs since = now_ns_ - status_sent_ns_;
  const bool news = status_is_news_ && (since >= auction.tick_ns || round_is_reported(update));
  const bool due = now_ns_ - whole_sent_ns_ >= auction.lease_ns / heartbeats_a_lease;
  if (!news && !due) return;
  const bool whole = due || phase_ == Phase::routed;  // whoever waits for the end wants it all
  StatusMessage message = status(whole);
  message.header = header();
  update.statuses.push_back(std::move(message));
  status_is_news_ = false;
  round_was_told_ = true;
  status_sent_ns_ = now_ns_;
  if (!whole) return;
  whole_sent_ns_ = now_ns_;
  said_keys_ = view_.keys();
  said_heartbeats_ = membership_.heartbeats();
}

TimeNs Agent::next_wake() const {
  const AuctionSettings& auction = mission_->auction;
  TimeNs wake = whole_sent_ns_ + auction.lease_ns / heartbeats_a_lease;
  if (status_is_news_) wake = std::min(wake, status_sent_ns_ + auction.tick_ns);
  if (phase_ == Phase::waiting_for_peers) return std::min(wake, born_ns_ + auction.barrier_ns);
  for (std::size_t k = 0; k < view_.roster().size(); ++k)
    if (!view_.dead(k)) wake = std::min(wake, membership_.deadline(k, auction.lease_ns));
  if (undecided_) wake = round_is_over() ? now_ns_ : std::min(wake, decided_ns_ + auction.tick_ns);
  if (dissemination_.anyone_lacks(view_)) wake = std::min(wake, now_ns_ + auction.tick_ns);
  return std::max(wake, now_ns_);
}

}  // namespace arcbid
