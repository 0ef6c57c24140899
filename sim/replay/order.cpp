// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/replay/order.hpp"

#include <algorithm>
#include <map>
#include <queue>

namespace arcbid {
namespace {

/// Which of a sender's messages are on record: by life of the message's header, first numbers of
/// the steps that sent them.
struct Sent {
  std::size_t life = 0;
  std::uint64_t incarnation = 0;
  std::vector<std::pair<std::uint64_t, std::size_t>> steps;  // (first number, mark), ascending
};

class Merge {
 public:
  explicit Merge(const RunArchive& run) : run_(run), next_(run.lives.size(), 0) {
    for (std::size_t l = 0; l < run.lives.size(); ++l) {
      Sent sent{l, run.lives[l].incarnation(), {}};
      const auto& marks = run.lives[l].marks();
      for (std::size_t m = 0; m < marks.size(); ++m)
        if (marks[m].sent > 0) sent.steps.emplace_back(marks[m].first_sent, m);
      senders_[run.lives[l].agent()].push_back(std::move(sent));
    }
    for (auto& [agent, sent] : senders_)
      std::stable_sort(sent.begin(), sent.end(),
                       [](const Sent& a, const Sent& b) { return a.incarnation < b.incarnation; });
  }

  std::vector<Moment> ordered() {
    for (std::size_t l = 0; l < next_.size(); ++l) offer(l);
    while (!ready_.empty() || release_one()) {
      const auto [t_ns, life] = ready_.top();
      ready_.pop();
      take(life);
    }
    return std::move(out_);
  }

 private:
  using Ready = std::pair<TimeNs, std::size_t>;  // time, life

  /// The step that sent it; none: not on record, and nothing to wait for.
  std::optional<std::pair<std::size_t, std::size_t>> cause(const Mark& mark) const {
    if (!mark.heard) return {};
    const auto of = senders_.find(mark.heard->sender);
    if (of == senders_.end()) return {};
    // A life begins with its birth's incarnation and may go on under higher ones.
    const auto later = std::upper_bound(
        of->second.begin(), of->second.end(), mark.heard->incarnation,
        [](std::uint64_t incarnation, const Sent& sent) { return incarnation < sent.incarnation; });
    if (later == of->second.begin()) return {};
    const Sent& sent = *std::prev(later);
    const auto after = std::upper_bound(
        sent.steps.begin(), sent.steps.end(), mark.heard->sequence,
        [](std::uint64_t number, const auto& step) { return number < step.first; });
    if (after == sent.steps.begin()) return {};
    return std::pair(sent.life, std::prev(after)->second);
  }
  void offer(std::size_t life) {
    const auto& marks = run_.lives[life].marks();
    if (next_[life] >= marks.size()) return;
    const Mark& mark = marks[next_[life]];
    const auto from = cause(mark);
    if (from && from->first != life && next_[from->first] <= from->second)
      waiting_[from->first].push_back(life);
    else
      ready_.push({mark.t_ns, life});
  }
  void take(std::size_t life) {
    const TimeNs own_ns = run_.lives[life].marks()[next_[life]].t_ns;
    latest_ns_ = std::max(latest_ns_, own_ns);
    out_.push_back({life, next_[life]++, latest_ns_});
    offer(life);
    for (const std::size_t other : std::exchange(waiting_[life], {})) offer(other);
  }
  /// Logs that contradict each other (a number used twice) must not stop everything.
  bool release_one() {
    for (auto& [sender, lives] : waiting_)
      if (!lives.empty()) {
        const std::size_t life = lives.back();
        lives.pop_back();
        ready_.push({run_.lives[life].marks()[next_[life]].t_ns, life});
        return true;
      }
    return false;
  }

  const RunArchive& run_;
  std::vector<std::size_t> next_;
  std::map<AgentId, std::vector<Sent>> senders_;
  std::map<std::size_t, std::vector<std::size_t>> waiting_;  // sender's life: who waits for it
  std::priority_queue<Ready, std::vector<Ready>, std::greater<>> ready_;
  std::vector<Moment> out_;
  TimeNs latest_ns_ = INT64_MIN;
};

}  // namespace

std::vector<Moment> causal_order(const RunArchive& run) {
  return Merge(run).ordered();
}

}  // namespace arcbid
