// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/route/make_transit.hpp"

#include <utility>
#include <vector>

#include "core/airspace/runs.hpp"
#include "core/auction/task_set.hpp"
#include "core/base/error.hpp"

namespace arcbid {

std::shared_ptr<const Transit> make_transit(const Mission& mission) {
  if (mission.airspace.empty()) return std::make_shared<const StraightTransit>();
  return make_obstacle_transit(mission);
}

std::shared_ptr<const ObstacleTransit> make_obstacle_transit(const Mission& mission,
                                                             std::vector<double> table) {
  if (const auto reason = unsound(mission.airspace))
    throw InputError("mission: airspace." + *reason);
  const TaskSet set = split(mission.arcs, mission.auction.split_m, mission.auction.max_tasks);
  std::vector<Vec3> places;
  for (const Uav& uav : mission.fleet) places.push_back(uav.home_m);
  for (const Task& task : set.tasks) {
    places.push_back(task.first_m);
    places.push_back(task.last_m);
  }
  return std::make_shared<const ObstacleTransit>(mission.airspace, mission.arcs, places, 0,
                                                 std::move(table));
}

}  // namespace arcbid
