// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/replay/evidence.hpp"

#include <algorithm>

namespace arcbid {
namespace {

/// A life that refutes its death goes on under the next incarnation; a new one begins at the clock.
constexpr std::uint64_t most_refutations = 100;

void add(HeardOnly& to, const MessageId& message, TimeNs t_ns) {
  to.first_ns = to.messages == 0 ? t_ns : std::min(to.first_ns, t_ns);
  to.last_ns = to.messages == 0 ? t_ns : std::max(to.last_ns, t_ns);
  ++to.messages;
  to.numbers.emplace_back(message.sequence, message.sequence);
}

/// 3 4 5 9: 3 to 5, 9.
void join(std::vector<std::pair<std::uint64_t, std::uint64_t>>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  std::size_t kept = 0;
  for (std::size_t n = 1; n < numbers.size(); ++n)
    if (numbers[n].first <= numbers[kept].second + 1)
      numbers[kept].second = std::max(numbers[kept].second, numbers[n].second);
    else
      numbers[++kept] = numbers[n];
  numbers.resize(kept + 1);
}

}  // namespace

void Evidence::sent(std::size_t log, const MessageId& message) {
  sent_.push_back(message);
  Spoken& last = last_[log];
  last.incarnation = std::max(last.incarnation, message.incarnation);
  last.sequence = std::max(last.sequence, message.sequence);
}

void Evidence::heard(const MessageId& message, TimeNs t_ns) {
  const auto [at, is_new] = heard_.emplace(message, t_ns);
  if (!is_new) at->second = std::min(at->second, t_ns);
}

std::size_t Evidence::life_of(const MessageId& message, std::vector<LogReport>& logs) const {
  std::optional<std::size_t> found;
  for (std::size_t l = 0; l < logs.size(); ++l)
    if (logs[l].role == "agent" && logs[l].agent == message.sender.value &&
        logs[l].life <= message.incarnation && (!found || logs[l].life > logs[*found].life))
      found = l;
  if (found) {
    const auto last = last_.find(*found);
    const std::uint64_t known = last == last_.end()
                                    ? logs[*found].life
                                    : std::max(logs[*found].life, last->second.incarnation);
    if (message.incarnation <= known + most_refutations) return *found;
  }
  LogReport missing;
  missing.role = "agent";
  missing.agent = message.sender.value;
  missing.life = message.incarnation;
  missing.not_read = "there is no log of it";
  logs.push_back(std::move(missing));
  return logs.size() - 1;
}

void Evidence::judge(std::vector<LogReport>& logs) const {
  std::vector<MessageId> on_record = sent_;
  std::sort(on_record.begin(), on_record.end());
  for (const auto& [message, t_ns] : heard_) {
    if (std::binary_search(on_record.begin(), on_record.end(), message)) continue;
    LogReport& log = logs[life_of(message, logs)];
    if (log.unread_schema) continue;  // it may well be on its record
    if (!log.heard_only) log.heard_only.emplace();
    add(*log.heard_only, message, t_ns);
  }
  for (std::size_t l = 0; l < logs.size(); ++l) {
    if (!logs[l].heard_only) continue;
    HeardOnly& heard = *logs[l].heard_only;
    join(heard.numbers);
    const auto last = last_.find(l);
    heard.behind_its_end =
        last == last_.end() || heard.numbers.front().first > last->second.sequence;
  }
}

}  // namespace arcbid
