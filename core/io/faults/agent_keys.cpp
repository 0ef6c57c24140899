// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/faults/fault_keys.hpp"

namespace arcbid::yaml {
namespace {

using F = AgentFault;
using K = AgentFaultKind;

constexpr double shortest_s = 0.001;

Key<F> at(bool required) {
  return field<F>("at_s", &F::at_ns, seconds(0, longest_s), "When.", required);
}

Key<F> lasting(const std::string& name, const std::string& meaning, bool required = false) {
  return field<F>(name, &F::for_ns, optional_of(seconds(shortest_s, longest_s)), meaning, required);
}

Kind<Malformation> malformation() {
  return choice(enumerators<Malformation>(malformation_names));
}

void read_agent_fault(const Place& place, F& fault, Report& report) {
  std::string given;  // the fault's kind
  Keys<F> keys = {field<F>("agent", &F::agent, agent_or_coordinator(), "Whose fault it is.", true)};
  for (const AgentFaultKey& of_kind : agent_fault_keys())
    keys.push_back({of_kind.name, mapping(of_kind.keys).legal, of_kind.meaning,
                    [&](const Place& value, F& owner, Report& r) {
                      if (!given.empty())
                        r.problem(value.at, value.path,
                                  fmt::format("besides {}; one fault an entry", given));
                      given = of_kind.name;
                      owner.kind = of_kind.kind;
                      read_fields(value, of_kind.keys, owner, r);
                    },
                    [](const F&) { return std::string(); }});
  read_fields(place, keys, fault, report);
  if (!given.empty()) return;
  std::vector<std::string> words;
  for (const AgentFaultKey& of_kind : agent_fault_keys()) words.push_back(of_kind.name);
  report.problem(place.at, place.path,
                 fmt::format("says no fault; legal: one of {}", fmt::join(words, ", ")));
}

std::string print_agent_fault(const F& fault) {
  std::string text;
  for (const AgentFaultKey& of_kind : agent_fault_keys())
    if (of_kind.kind == fault.kind)
      text = fmt::format("{{agent: {}, {}: {}}}", agent_or_coordinator().print(fault.agent),
                         of_kind.name, print_fields(of_kind.keys, fault));
  return text;
}

}  // namespace

const std::vector<AgentFaultKey>& agent_fault_keys() {
  static const std::vector<AgentFaultKey> all = {
      {K::crash,
       "crash",
       "Killed (SIGKILL).",
       {at(true), lasting("back_after_s", "Started again this much later; absent: never.")}},
      {K::pause,
       "pause",
       "Stopped (SIGSTOP).",
       {at(true), lasting("for_s", "Goes on (SIGCONT) this much later; absent: never.")}},
      {K::late, "late", "Starts later than the others.", {lasting("by_s", "By how much.", true)}},
      {K::clock,
       "clock",
       "Its clock is wrong.",
       {at(false), lasting("for_s", "For how long; absent: for good."),
        field<F>("offset_s", &F::offset_ns, seconds(-longest_s, longest_s),
                 "How far it is ahead; less than 0: behind."),
        field<F>("drift", &F::drift, number<double>(-0.5, 0.5), "Seconds gained a second.")}},
      {K::twin,
       "twin",
       "A second process with the same id.",
       {at(true), lasting("for_s", "For how long; absent: for good.")}},
      {K::malformed,
       "malformed",
       "Sends what must be refused.",
       {at(true), field<F>("what", &F::malformation, malformation(), "What is wrong.", true),
        field<F>("count", &F::count, number<std::uint32_t>(1, 100'000), "How often.")}},
  };
  return all;
}

Kind<AgentFault> agent_fault() {
  return {"an agent and one fault", read_agent_fault, print_agent_fault};
}

}  // namespace arcbid::yaml
