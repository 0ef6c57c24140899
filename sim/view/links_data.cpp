// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <set>
#include <tuple>

#include "core/io/run/agent_log.hpp"
#include "sim/view/view_data.hpp"

namespace arcbid {
namespace {

using nlohmann::json;

constexpr TimeNs bin_ns = 50'000'000;

using Cell = std::tuple<std::int64_t, std::uint32_t, std::uint32_t>;  // bin, from, to
struct Counts {
  std::uint64_t sent = 0, lost = 0, delayed = 0, duplicated = 0;
};

/// Hears of every record of a kind that is intact, if it is an object.
template <class Take>
void read(const LifeLog& life, std::string_view kind, const Take& take) {
  const auto taken = [&](const RunLogReader::Record& record) {
    if (record.kind != kind) return true;
    const json body = json::parse(record.body, nullptr, false);
    if (body.is_object()) take(record.t_ns, body);
    return true;
  };
  if (life.damage())
    life.reader().read_intact(taken, [](const RunLogReader::Lost&) {});
  else
    life.reader().read(taken, 0, kind);
}

/// None: the record does not say which message it was. Older logs leave out the incarnation.
std::optional<MessageId> message_in(const json& body) {
  const auto number = [&body](const char* key) {
    const json value = body.value(key, json());
    return value.is_number_unsigned() ? std::optional(value.get<std::uint64_t>()) : std::nullopt;
  };
  const auto sender = number("sender");
  if (!sender) return std::nullopt;
  return MessageId{AgentId{static_cast<std::uint32_t>(*sender)}, number("incarnation").value_or(0),
                   number("sequence").value_or(0)};
}

/// Counts what came to the agents, each message once: when it came, not when its copies were heard.
/// A copy may be heard by a later life than the one it came to.
class Arrivals {
 public:
  explicit Arrivals(const std::vector<LifeLog>& lives) {
    for (const LifeLog& life : lives) take_records(life);
    for (const LifeLog& life : lives) {
      // What was said while nobody was there to write it down may still be heard, and twice.
      std::set<MessageId>& met = met_[life.agent()];
      for (const Mark& mark : life.marks())
        if (mark.heard && met.insert(*mark.heard).second)
          sent(mark.t_ns, *mark.heard, life.agent());
    }
  }
  const std::map<Cell, Counts>& cells() const { return cells_; }

 private:
  void take_records(const LifeLog& life) {
    const AgentId to = life.agent();
    read(life, log_kind::lost, [this, to](TimeNs t_ns, const json& body) {
      if (const auto message = message_in(body)) ++sent(t_ns, *message, to).lost;
    });
    read(life, log_kind::fate, [this, to](TimeNs t_ns, const json& body) { meet(t_ns, body, to); });
  }
  Counts& sent(TimeNs t_ns, const MessageId& message, AgentId to) {
    Counts& counts = cells_[{t_ns / bin_ns, message.sender.value, to.value}];
    ++counts.sent;
    return counts;
  }
  void meet(TimeNs t_ns, const json& body, AgentId to) {
    const auto message = message_in(body);
    const json after_ns = body.value("after_ns", json());
    if (!message || !after_ns.is_array() || after_ns.empty()) return;
    met_[to].insert(*message);
    Counts& counts = sent(t_ns, *message, to);
    if (after_ns[0].is_number_integer() && after_ns[0] > 0) ++counts.delayed;
    counts.duplicated += after_ns.size() - 1;
  }

  std::map<Cell, Counts> cells_;
  std::map<AgentId, std::set<MessageId>> met_;  // by receiver: those that are counted
};

}  // namespace

/// Each receiver's log says what came and what the fault schedule did to it.
json links_data(const RunArchive& run) {
  const Arrivals arrivals(run.lives);
  json rows = json::array();
  for (const auto& [cell, counts] : arrivals.cells()) {
    const auto& [bin, from, to] = cell;
    rows.push_back({bin, from, to, counts.sent, counts.lost, counts.delayed, counts.duplicated});
  }
  return {{"bin_s", seconds(bin_ns)}, {"rows", rows}};
}

}  // namespace arcbid
