// SPDX-License-Identifier: GPL-3.0-or-later
#include "agent/malformer.hpp"

#include <algorithm>

#include "core/faults/malform.hpp"

namespace arcbid {
namespace {

constexpr std::size_t remembered = 4;  // statements

}  // namespace

Malformer::Malformer(const FaultSchedule& schedule, AgentId self, std::size_t tasks, TimeNs tick_ns)
    : tasks_(tasks), tick_ns_(tick_ns) {
  for (const AgentFault& fault : schedule.agents)
    if (fault.agent == self && fault.kind == AgentFaultKind::malformed)
      faults_.push_back({fault.at_ns, fault.malformation, fault.count});
}

void Malformer::said(const BidMessage& bid) {
  said_ = bid;
  if (history_.size() < remembered) history_.push_back(bid);
}

BidMessage Malformer::spoilt(const Fault& fault) const {
  if (fault.how == Malformation::replay) return history_[fault.left % history_.size()];
  return malformed(*said_, fault.how, tasks_);
}

void Malformer::bid_over(const Fault& fault, Speech& speech) const {
  BidMessage bad = over_bid(*said_, tasks_);
  for (std::uint32_t n = 0; n < fault.left; ++n) {
    ++bad.header.sequence;
    speech.messages.push_back({fault.how, bad});
  }
  speech.ends = true;
}

Malformer::Speech Malformer::due(TimeNs now_ns) {
  Speech speech;
  if (!said_) return speech;
  for (Fault& fault : faults_) {
    if (fault.next_ns > now_ns) continue;
    if (fault.how == Malformation::over_bid) {
      bid_over(fault, speech);
      return speech;
    }
    speech.messages.push_back({fault.how, spoilt(fault)});
    --fault.left;
    fault.next_ns = now_ns + tick_ns_;
  }
  std::erase_if(faults_, [](const Fault& fault) { return fault.left == 0; });
  return speech;
}

std::optional<TimeNs> Malformer::next_ns() const {
  if (!said_ || faults_.empty()) return std::nullopt;
  const auto earlier = [](const Fault& a, const Fault& b) { return a.next_ns < b.next_ns; };
  return std::min_element(faults_.begin(), faults_.end(), earlier)->next_ns;
}

}  // namespace arcbid
