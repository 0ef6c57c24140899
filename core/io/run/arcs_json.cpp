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
                   {"speed_mps", uav.speed_mps},
                   {"endurance_s", uav.endurance_s ? json(*uav.endurance_s) : json(nullptr)},
                   {"payload", name_of(uav.payload)}});
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
                   {"payload", name_of(arc.payload)},
                   {"waypoints", waypoints}});
  }
  return out;
}

json no_bidders_json(const std::vector<NoBidder>& left) {
  json out = json::array();
  for (const NoBidder& one : left)
    out.push_back({{"arc", one.arc.value},
                   {"from_m", one.from_m},
                   {"to_m", one.to_m},
                   {"why", name_of(one.why)},
                   {"needs", name_of(one.needs)},
                   {"agent", one.nearest ? json(one.nearest->value) : json(nullptr)},
                   {"needed_s", one.needed_s},
                   {"endurance_s", one.endurance_s},
                   {"limit", one.limit},
                   {"text", to_text(one)}});
  return out;
}

}  // namespace arcbid
