// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/launcher/fault_script.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace arcbid {
namespace {

constexpr TimeNs settle_ns = 500'000'000;

}  // namespace

std::string in_words(const ProcessFault& fault) {
  const std::string who =
      fault.agent.value == 0 ? "coordinator" : fmt::format("agent {}", fault.agent.value);
  switch (fault.action) {
    case ProcessAction::kill:
      return who + " is killed";
    case ProcessAction::start:
      return who + " is started";
    case ProcessAction::pause:
      return who + " is paused";
    case ProcessAction::resume:
      return who + " goes on";
    case ProcessAction::start_twin:
      return "a second process starts as " + who;
    case ProcessAction::kill_twin:
      return "the second process of " + who + " is killed";
  }
  return who;
}

FaultScript::FaultScript(const FaultSchedule& schedule) {
  const auto add = [this](TimeNs at_ns, AgentId agent, ProcessAction action) {
    faults_.push_back({at_ns, agent, action});
  };
  using Kind = AgentFaultKind;
  for (const AgentFault& fault : schedule.agents) {
    const TimeNs end_ns = fault.at_ns + fault.for_ns.value_or(0);
    if (fault.kind == Kind::crash) {
      add(fault.at_ns, fault.agent, ProcessAction::kill);
      if (fault.for_ns) add(end_ns, fault.agent, ProcessAction::start);
    } else if (fault.kind == Kind::pause) {
      add(fault.at_ns, fault.agent, ProcessAction::pause);
      if (fault.for_ns) add(end_ns, fault.agent, ProcessAction::resume);
    } else if (fault.kind == Kind::late) {
      add(fault.for_ns.value_or(0), fault.agent, ProcessAction::start);
    } else if (fault.kind == Kind::twin) {
      add(fault.at_ns, fault.agent, ProcessAction::start_twin);
      if (fault.for_ns) add(end_ns, fault.agent, ProcessAction::kill_twin);
    } else if (fault.kind == Kind::malformed) {
      spoken_.push_back(fault);
    }
  }
  std::stable_sort(faults_.begin(), faults_.end(),
                   [](const auto& a, const auto& b) { return a.at_ns < b.at_ns; });
}

bool FaultScript::comes_late(AgentId agent) const {
  const auto first = std::find_if(faults_.begin(), faults_.end(),
                                  [&](const ProcessFault& f) { return f.agent == agent; });
  return first != faults_.end() && first->action == ProcessAction::start;
}

bool FaultScript::next(TimeNs now_ns, ProcessFault& fault) {
  if (done_ == faults_.size() || faults_[done_].at_ns > now_ns) return false;
  fault = faults_[done_++];
  return true;
}

bool FaultScript::returns(AgentId agent) const {
  return std::any_of(
      faults_.begin() + static_cast<std::ptrdiff_t>(done_), faults_.end(),
      [&](const auto& f) { return f.agent == agent && f.action == ProcessAction::start; });
}

TimeNs FaultScript::over_ns(TimeNs lease_ns, TimeNs tick_ns) const {
  TimeNs over = 0;
  for (const AgentFault& fault : spoken_) {
    const bool ends = fault.malformation == Malformation::over_bid;
    const TimeNs said_ns = ends ? lease_ns + settle_ns : static_cast<TimeNs>(fault.count) * tick_ns;
    over = std::max(over, fault.at_ns + settle_ns + said_ns);
  }
  for (const ProcessFault& fault : faults_) {
    const bool ends = fault.action == ProcessAction::kill || fault.action == ProcessAction::pause;
    over = std::max(over, fault.at_ns + settle_ns + (ends ? lease_ns + settle_ns : 0));
  }
  return over;
}

}  // namespace arcbid
