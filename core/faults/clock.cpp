// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "core/faults/link_model.hpp"

namespace arcbid {

TimeNs clock_of(const FaultSchedule& schedule, AgentId agent, TimeNs now_ns) {
  TimeNs shown_ns = now_ns;
  for (const AgentFault& fault : schedule.agents) {
    if (fault.agent != agent || fault.kind != AgentFaultKind::clock) continue;
    const TimeNs since_ns = now_ns - fault.at_ns;
    if (since_ns < 0 || (fault.for_ns && since_ns >= *fault.for_ns)) continue;
    shown_ns += fault.offset_ns + std::llround(fault.drift * static_cast<double>(since_ns));
  }
  return shown_ns;
}

}  // namespace arcbid
