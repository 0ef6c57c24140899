// SPDX-License-Identifier: GPL-3.0-or-later
#include "agent/route_planner.hpp"

#include <sys/resource.h>
#include <sys/types.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <utility>

namespace arcbid {
namespace {

constexpr int niceness = 19;

PlannedFlight planned(const Mission& mission, const Transit& transit, const TaskSet& tasks,
                      const Agreement& agreement, AgentId self, const std::atomic<bool>& wanted) {
  const auto uav =
      std::ranges::find_if(mission.fleet, [self](const Uav& u) { return u.id == self; });
  const auto is_wanted = [&wanted] { return wanted.load(); };
  Share share = share_of(mission, tasks, agreement, self, transit, is_wanted);
  Route route = plan_route(mission, tasks, share.path, *uav, transit, is_wanted);
  if (!wanted) return {};
  return {agreement.view_hash, std::move(share), std::move(route)};
}

}  // namespace

void RoutePlanner::plan(std::shared_ptr<const Mission> mission,
                        std::shared_ptr<const Transit> transit, const TaskSet& tasks,
                        const Agreement& agreement, AgentId self) {
  is_wanted_ = true;
  planning_ = std::async(
      std::launch::async,
      [this, mission = std::move(mission), transit = std::move(transit), &tasks, agreement, self] {
        // Others may still be at the auction, on this very machine.
        setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), niceness);
        PlannedFlight flight = planned(*mission, *transit, tasks, agreement, self, is_wanted_);
        done_();
        return flight;
      });
}

std::optional<PlannedFlight> RoutePlanner::take() {
  if (!busy() || planning_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
    return std::nullopt;
  return planning_.get();
}

}  // namespace arcbid
