// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/export/scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace arcbid {
namespace {

// Okabe and Ito (2008) without black: told apart by every kind of colour vision, on any ground.
constexpr std::array<ros::ColorRGBA, 7> colours{{{0.00f, 0.45f, 0.70f, 1},
                                                 {0.90f, 0.62f, 0.00f, 1},
                                                 {0.00f, 0.62f, 0.45f, 1},
                                                 {0.80f, 0.47f, 0.65f, 1},
                                                 {0.34f, 0.71f, 0.91f, 1},
                                                 {0.84f, 0.37f, 0.00f, 1},
                                                 {0.94f, 0.89f, 0.26f, 1}}};
constexpr ros::ColorRGBA nobodys{0.6f, 0.6f, 0.6f, 1};

ros::Header header(TimeNs t_ns) {
  return {static_cast<std::uint64_t>(std::max<TimeNs>(t_ns, 0)), "map"};
}

ros::Point point(const Vec3& at) {
  return {at.x(), at.y(), at.z()};
}

/// Turns the x axis to `look`, without a roll.
ros::Quaternion towards(const Vec3& look) {
  const double yaw = std::atan2(look.y(), look.x()) / 2;
  const double pitch = -std::atan2(look.z(), std::hypot(look.x(), look.y())) / 2;
  return {-std::sin(pitch) * std::sin(yaw), std::sin(pitch) * std::cos(yaw),
          std::cos(pitch) * std::sin(yaw), std::cos(pitch) * std::cos(yaw)};
}

ros::Pose pose_at(const Waypoint& waypoint) {
  return {point(waypoint.position_m), towards(waypoint.look)};
}

/// What a display still shows of the message before is gone.
ros::Marker clear(TimeNs t_ns, const std::string& ns) {
  ros::Marker marker;
  marker.header = header(t_ns);
  marker.ns = ns;
  marker.action = ros::MarkerAction::remove_all;
  return marker;
}

}  // namespace

Scene::Scene(const Mission& mission, const TaskSet& tasks) : mission_(mission) {
  for (const Task& task : tasks.tasks) {
    const auto polyline = part(mission.arcs[task.arc.value].waypoints, task.from_m, task.to_m);
    auto& ends = pieces_.emplace_back();
    for (std::size_t w = 1; w < polyline.size(); ++w) {
      ends.push_back(point(polyline[w - 1].position_m));
      ends.push_back(point(polyline[w].position_m));
    }
  }
}

ros::ColorRGBA Scene::colour(const std::optional<AgentId>& agent) const {
  for (std::size_t k = 0; agent && k < mission_.fleet.size(); ++k)
    if (mission_.fleet[k].id == *agent) return colours[k % colours.size()];
  return nobodys;
}

ros::MarkerArray Scene::homes(TimeNs t_ns) const {
  ros::MarkerArray out;
  for (const Uav& uav : mission_.fleet) {
    ros::Marker home;
    home.header = header(t_ns);
    home.ns = "homes";
    home.id = static_cast<std::int32_t>(uav.id.value);
    home.pose.position = point(uav.home_m);
    home.scale = {1, 1, 1};
    home.color = colour(uav.id);
    ros::Marker name = home;
    name.ns = "names";
    name.type = ros::MarkerType::text_view_facing;
    name.pose.position.z += 1.5;
    name.text = std::to_string(uav.id.value);
    out.markers.push_back(std::move(home));
    out.markers.push_back(std::move(name));
  }
  return out;
}

ros::MarkerArray Scene::arcs(TimeNs t_ns, const std::vector<Belief>& owners) const {
  std::map<std::optional<AgentId>, ros::Marker> of;
  for (std::size_t j = 0; j < pieces_.size(); ++j) {
    const auto& owner = owners[j].winner;
    ros::Marker& lines = of[owner];
    lines.points.insert(lines.points.end(), pieces_[j].begin(), pieces_[j].end());
  }
  ros::MarkerArray out{{clear(t_ns, "arcs")}};
  for (auto& [owner, lines] : of) {
    lines.header = header(t_ns);
    lines.ns = "arcs";
    lines.id = owner ? static_cast<std::int32_t>(owner->value) : -1;
    lines.type = ros::MarkerType::line_list;
    lines.scale.x = owner ? 0.3 : 0.15;
    lines.color = colour(owner);
    out.markers.push_back(std::move(lines));
  }
  return out;
}

ros::Path Scene::path(TimeNs t_ns, const Route& route) {
  ros::Path out{header(t_ns), {}};
  for (const RouteLeg& leg : route.legs)
    for (const Waypoint& waypoint : leg.waypoints)
      out.poses.push_back({header(t_ns), pose_at(waypoint)});
  return out;
}

ros::PointCloud2 Scene::cloud(TimeNs t_ns, const Structure& structure) {
  ros::PointCloud2 out{header(t_ns), {}};
  for (const Vec3& at : structure.points) {
    const Eigen::Vector3f p = at.cast<float>();
    out.points.push_back({p.x(), p.y(), p.z()});
  }
  return out;
}

ros::MarkerArray Scene::mesh(TimeNs t_ns, const Structure& structure) {
  ros::Marker triangles;
  triangles.header = header(t_ns);
  triangles.ns = "structure";
  triangles.type = ros::MarkerType::triangle_list;
  triangles.scale = {1, 1, 1};
  triangles.color = nobodys;
  for (const auto& triangle : structure.triangles)
    for (const std::uint32_t corner : triangle)
      triangles.points.push_back(point(structure.points[corner]));
  return {{std::move(triangles)}};
}

Flight::Flight(const Route& route) : time_s_(route.time_s) {
  const double speed = route.time_s > 0 ? route.length_m / route.time_s : 1;
  double flown_m = 0;
  for (const RouteLeg& leg : route.legs)
    for (const Waypoint& waypoint : leg.waypoints) {
      if (!stops_.empty())
        flown_m += (waypoint.position_m - stops_.back().waypoint.position_m).norm();
      stops_.push_back({flown_m / speed, waypoint});
    }
}

ros::Pose Flight::pose(double at_s) const {
  const auto after =
      std::upper_bound(stops_.begin(), stops_.end(), at_s,
                       [](double time_s, const Stop& stop) { return time_s < stop.at_s; });
  if (after == stops_.end()) return pose_at(stops_.back().waypoint);
  if (after == stops_.begin()) return pose_at(after->waypoint);
  const Stop& from = *std::prev(after);
  const double share = (at_s - from.at_s) / (after->at_s - from.at_s);
  const Waypoint &a = from.waypoint, &b = after->waypoint;
  return pose_at(
      {a.position_m + share * (b.position_m - a.position_m), a.look + share * (b.look - a.look)});
}

}  // namespace arcbid
