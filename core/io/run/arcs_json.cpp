// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/run/arcs_json.hpp"

#include <fmt/format.h>

namespace arcbid {

using nlohmann::json;

std::string hex(std::uint64_t value) {
  return fmt::format("{:016x}", value);
}

json waypoint_json(const Waypoint& w) {
  return {w.position_m.x(), w.position_m.y(), w.position_m.z(), w.look.x(), w.look.y(), w.look.z()};
}

json fleet_json(const Mission& mission) {
  json out = json::array();
  for (const Uav& uav : mission.fleet)
    out.push_back({{"agent", uav.id.value},
                   {"home_m", {uav.home_m.x(), uav.home_m.y(), uav.home_m.z()}},
                   {"speed_mps", uav.speed_mps}});
  return out;
}

json arcs_json(const Mission& mission) {
  json out = json::array();
  for (const Arc& arc : mission.arcs) {
    json waypoints = json::array();
    for (const Waypoint& w : arc.waypoints) waypoints.push_back(waypoint_json(w));
    out.push_back({{"arc", arc.id.value},
                   {"kind", name(arc.kind)},
                   {"length_m", length_m(arc.waypoints)},
                   {"waypoints", waypoints}});
  }
  return out;
}

}  // namespace arcbid
