// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/route/route.hpp"
#include "core/structure/structure.hpp"
#include "sim/mcap/ros_types.hpp"
#include "sim/replay/run_archive.hpp"

namespace arcbid {

/// What is seen of a run, as messages of ROS 2. The frame is "map": local East-North-Up, metres.
class Scene {
 public:
  Scene(const Mission& mission, const TaskSet& tasks);

  /// Every home with its agent's number, in the agent's colour.
  ros::MarkerArray homes(TimeNs t_ns) const;
  /// All arcs, each piece in its owner's colour; grey: nobody's. Whole: it replaces the one before.
  ros::MarkerArray arcs(TimeNs t_ns, const std::vector<Belief>& owners) const;
  static ros::Path path(TimeNs t_ns, const Route& route);
  /// All points; of a mesh, its vertices.
  static ros::PointCloud2 cloud(TimeNs t_ns, const Structure& structure);
  /// All triangles of a mesh.
  static ros::MarkerArray mesh(TimeNs t_ns, const Structure& structure);

 private:
  ros::ColorRGBA colour(const std::optional<AgentId>& agent) const;

  const Mission& mission_;
  std::vector<std::vector<ros::Point>> pieces_;  // by task: both ends of every segment
};

/// Where a drone is when it flies its route at its speed.
class Flight {
 public:
  explicit Flight(const Route& route);
  double time_s() const { return time_s_; }
  /// `at_s`: since take-off, at most time_s(). The x axis looks where the sensor looks.
  ros::Pose pose(double at_s) const;

 private:
  struct Stop {
    double at_s;
    Waypoint waypoint;
  };
  std::vector<Stop> stops_;  // ascending times
  double time_s_ = 0;
};

}  // namespace arcbid
