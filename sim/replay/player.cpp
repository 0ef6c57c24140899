// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/replay/player.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/base/error.hpp"

namespace arcbid {
namespace {

constexpr double met = 0.95;  // of the asked rate: less is worth telling

std::optional<double> number_in(std::string_view text) {
  double value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && stop == text.data() + text.size();
  return whole && std::isfinite(value) && std::abs(value) < 1e9 ? std::optional(value)
                                                                : std::nullopt;
}

bool names(const StatementBody& body, AgentId agent, const TaskSet& tasks, ArcId arc) {
  if (const auto* claims = std::get_if<Claims>(&body))
    return std::any_of(claims->bundle.begin(), claims->bundle.end(), [&](const Claim& claim) {
      return tasks.tasks[claim.task.value].arc == arc;
    });
  const std::vector<Belief>& beliefs = std::get<Table>(body).beliefs;
  for (std::size_t j = 0; j < beliefs.size(); ++j)
    if (beliefs[j].winner == agent && tasks.tasks[j].arc == arc) return true;
  return false;
}

}  // namespace

Player::Player(const RunArchive& run, const Playback& playback, MomentFilter filter)
    : run_(run), playback_(playback), filter_(filter), end_(playback.moments().size()) {
  if (end_ > 0) now_ns_ = playback.moments().front().t_ns;
}

/// After a jump: the time is the last passed moment's, and rates are measured anew.
void Player::moved() {
  const std::vector<Moment>& moments = playback_.moments();
  if (!moments.empty()) now_ns_ = moments[position_ == 0 ? 0 : position_ - 1].t_ns;
  played_ns_ = real_ns_ = 0;
}

void Player::seek(std::size_t position) {
  position_ = std::min(position, end_);
  moved();
}

void Player::seek_time(TimeNs t_ns) {
  seek(playback_.at(t_ns));
  if (!at_end()) now_ns_ = t_ns;
}

bool Player::seek_round(std::uint32_t round) {
  const std::vector<Moment>& moments = playback_.moments();
  for (std::size_t m = 0; m < moments.size(); ++m) {
    const Mark& mark = run_.lives[moments[m].life].marks()[moments[m].mark];
    if (!mark.decided || mark.round < round) continue;
    seek(m + 1);
    return true;
  }
  return false;
}

const std::vector<RunEvent>& Player::events() {
  if (!events_) events_ = run_events(run_, playback_);
  return *events_;
}

bool Player::seek_event(const std::string& name) {
  for (const RunEvent& event : events())
    if (event.name == name) {
      seek(event.moments);
      return true;
    }
  return false;
}

bool Player::next_event(int direction) {
  const RunEvent* to = nullptr;
  for (const RunEvent& event : events()) {
    if (direction > 0 && event.moments > position_ && !to) to = &event;
    if (direction < 0 && event.moments < position_) to = &event;
  }
  if (to) seek(to->moments);
  return to != nullptr;
}

void Player::seek(const std::string& where) {
  if (where.starts_with("round:")) {
    const auto round = number_in(std::string_view(where).substr(6));
    if (round && *round >= 1 && seek_round(static_cast<std::uint32_t>(*round))) return;
  } else if (where.starts_with("event:")) {
    if (seek_event(where.substr(6))) return;
  } else if (const auto seconds = number_in(where)) {
    return seek_time(static_cast<TimeNs>(std::llround(*seconds * 1e9)));
  }
  std::string legal;
  for (const RunEvent& event : events())
    if (legal.find("event:" + event.name + ",") == std::string::npos)
      legal += "event:" + event.name + ", ";
  throw InputError(fmt::format("{}: is nowhere in this run; legal: seconds, round:N, {}", where,
                               legal.substr(0, legal.size() - 2)));
}

void Player::set_until(const std::string& where) {
  const std::size_t here = position_;
  seek(where);
  const std::size_t until = position_;
  seek(here);
  end_ = until;
  position_ = std::min(position_, end_);
}

bool Player::is_shown(std::size_t at) const {
  const Moment& moment = playback_.moments()[at];
  const LifeLog& log = run_.lives[moment.life];
  const Mark& mark = log.marks()[moment.mark];
  if (filter_.agent && log.agent() != *filter_.agent) return false;
  if (filter_.topic == Topic::decision && !mark.decided) return false;
  if (filter_.topic && *filter_.topic != Topic::decision &&
      mark.event != static_cast<std::uint8_t>(*filter_.topic))
    return false;
  return !filter_.arc || concerns(moment, mark, *filter_.arc);
}

bool Player::concerns(const Moment& moment, const Mark& mark, ArcId arc) const {
  if (!mark.changed && !(mark.heard && mark.learnt)) return false;
  const LifeLog& log = run_.lives[moment.life];
  const Step step = log.step(moment.mark);
  const auto about = [&](const Statement& said) {
    return names(said.body, said.agent, run_.tasks, arc);
  };
  if (step.update.decision && names(step.update.decision->body, log.agent(), run_.tasks, arc))
    return true;
  if (const auto* bid = std::get_if<BidMessage>(&step.event.what)) return about(bid->statement);
  const auto* relay = std::get_if<RelayMessage>(&step.event.what);
  return relay && about(relay->statement);
}

std::vector<std::size_t> Player::step(int shown) {
  std::vector<std::size_t> passed;
  for (; shown > 0 && position_ < end_; ++position_)
    if (is_shown(position_)) {
      passed.push_back(position_);
      if (--shown == 0) {
        ++position_;
        break;
      }
    }
  for (; shown < 0 && position_ > 0; --position_)
    if (is_shown(position_ - 1)) {
      passed.insert(passed.begin(), position_ - 1);
      if (++shown == 0) {
        --position_;
        break;
      }
    }
  moved();
  return passed;
}

std::vector<std::size_t> Player::advance(TimeNs real_ns, std::size_t most) {
  const std::vector<Moment>& moments = playback_.moments();
  const TimeNs from_ns = now_ns_;
  TimeNs to_ns = INT64_MAX;
  if (rate_ > 0) to_ns = now_ns_ + static_cast<TimeNs>(static_cast<double>(real_ns) * rate_);
  std::vector<std::size_t> passed;
  while (position_ < end_ && moments[position_].t_ns <= to_ns && passed.size() < most) {
    if (is_shown(position_)) passed.push_back(position_);
    now_ns_ = std::max(now_ns_, moments[position_++].t_ns);
  }
  const bool all = position_ >= end_ || moments[position_].t_ns > to_ns;
  if (all && rate_ > 0 && position_ < end_) now_ns_ = to_ns;
  // What is left over at the end is nobody's delay.
  if (position_ < end_ || rate_ == 0) {
    played_ns_ += now_ns_ - from_ns;
    real_ns_ += real_ns;
  }
  if (at_end() && loops_ && begin_ < end_) {
    position_ = begin_;
    moved();
  }
  return passed;
}

std::optional<double> Player::real_rate() const {
  if (real_ns_ == 0) return std::nullopt;
  return static_cast<double>(played_ns_) / static_cast<double>(real_ns_);
}

bool Player::is_behind() const {
  const auto real = real_rate();
  return real && rate_ > 0 && *real < met * rate_;
}

}  // namespace arcbid
