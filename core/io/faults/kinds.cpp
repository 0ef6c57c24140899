// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/faults/kinds.hpp"

#include "core/faults/schedule.hpp"

namespace arcbid::yaml {
namespace {

constexpr double ns_per_s = 1e9;
constexpr TimeNs no_end_ns = Window{}.end_ns;
constexpr double greatest_id = 65535;
constexpr double most_bytes = 1e12;

}  // namespace

std::vector<std::pair<std::string, Place>> entries_of(const Place& place, Report& report) {
  std::vector<std::pair<std::string, Place>> entries;
  if (place.node.IsNull()) return entries;
  if (!place.node.IsMap()) {
    const std::string given = place.node.IsScalar() ? shown(place.node) : "a list";
    report.problem(place.at, place.path, given + " is not a mapping (lines of `key: value`)");
    return entries;
  }
  std::map<std::string, int> first_line;
  for (const auto& entry : place.node) {
    const YAML::Mark at = entry.first.Mark();
    if (!entry.first.IsScalar()) {
      report.problem(at, place.path, "a key must be a word");
      continue;
    }
    const std::string word = entry.first.Scalar();
    const std::string path = place.path.empty() ? word : place.path + "." + word;
    const auto [first, is_new] = first_line.emplace(word, at.line + 1);
    if (!is_new) {
      report.problem(at, path, fmt::format("given twice; first in line {}", first->second));
      continue;
    }
    const YAML::Mark value_at = entry.second.IsNull() ? at : entry.second.Mark();
    report.found(path, value_at);
    entries.push_back({word, {entry.second, value_at, path}});
  }
  return entries;
}

Kind<TimeNs> seconds(double low, double high) {
  const Kind<double> s = number<double>(low, high);
  return {s.legal,
          [=](const Place& place, TimeNs& value, Report& report) {
            if (const auto n = read_number(place, low, high, false, s.legal, report))
              value = std::llround(*n * ns_per_s);
          },
          [=](const TimeNs& value) { return s.print(static_cast<double>(value) / ns_per_s); }};
}

Kind<TimeNs> end_seconds() {
  const Kind<TimeNs> s = seconds(0, longest_s);
  return {s.legal, s.read,
          [=](const TimeNs& value) { return value == no_end_ns ? std::string() : s.print(value); }};
}

Kind<std::uint64_t> byte_count() {
  return number<std::uint64_t>(0, most_bytes);
}

Kind<AgentId> agent_id() {
  const Kind<std::uint32_t> plain = number<std::uint32_t>(1, greatest_id);
  return {
      "an agent's id",
      [=](const Place& place, AgentId& id, Report& report) { plain.read(place, id.value, report); },
      [=](const AgentId& id) { return plain.print(id.value); }};
}

Kind<AgentId> agent_or_coordinator() {
  const Kind<AgentId> agent = agent_id();
  const std::string legal = agent.legal + " or coordinator";
  return {legal,
          [=](const Place& place, AgentId& id, Report& report) {
            if (!is_scalar(place, legal, report)) return;
            const std::string word = place.node.Scalar();
            if (word == "coordinator")
              id = AgentId{0};
            else if (const std::string near = did_you_mean(word, {"coordinator"}); near.empty())
              agent.read(place, id, report);
            else
              report.problem(place.at, place.path,
                             fmt::format("{} is not {}{}", shown(place.node), legal, near));
          },
          [=](const AgentId& id) { return id.value == 0 ? "coordinator" : agent.print(id); }};
}

Kind<std::vector<AgentId>> agent_ids() {
  const Kind<AgentId> agent = agent_id();
  const Kind<std::vector<AgentId>> list = list_of(agent, most_agents, "ids");
  const std::string legal = "any, " + agent.legal + ", or " + list.legal;
  return {legal,
          [=](const Place& place, std::vector<AgentId>& ids, Report& report) {
            if (place.node.IsSequence()) {
              list.read(place, ids, report);
              if (ids.empty())
                report.problem(place.at, place.path, "an empty list; write any for all agents");
            } else if (is_scalar(place, legal, report) && place.node.Scalar() != "any") {
              agent.read(place, ids.emplace_back(), report);
            }
          },
          [=](const std::vector<AgentId>& ids) {
            if (ids.empty()) return std::string("any");
            return ids.size() == 1 ? agent.print(ids.front()) : list.print(ids);
          }};
}

}  // namespace arcbid::yaml
