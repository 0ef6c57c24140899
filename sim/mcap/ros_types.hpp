// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Messages of ROS 2's common interfaces, as far as an export uses them, laid out as in the
/// distributions from Humble on: lengths in metres, angles as unit quaternions, colours from 0
/// to 1. A message's `type` is its name there. encode() gives its bytes: CDR, little-endian, behind
/// the four bytes that say so; padding is zero.
namespace arcbid::ros {

struct Header {
  Header() = default;
  Header(std::uint64_t ns, std::string frame) : stamp_ns(ns), frame_id(std::move(frame)) {}

  std::uint64_t stamp_ns = 0;  ///< since any epoch, below 2^31 s
  std::string frame_id;        ///< the coordinate frame of all that follows
};

struct Point {
  double x = 0, y = 0, z = 0;
};
/// Extent along each axis.
using Vector3 = Point;

struct Quaternion {
  double x = 0, y = 0, z = 0, w = 1;
};

struct Pose {
  Point position = {};
  Quaternion orientation = {};
};

struct ColorRGBA {
  float r = 0, g = 0, b = 0, a = 1;
};

struct String {
  static constexpr std::string_view type = "std_msgs/msg/String";
  std::string data = {};
};

struct Float64 {
  static constexpr std::string_view type = "std_msgs/msg/Float64";
  double data = 0;
};

struct PoseStamped {
  static constexpr std::string_view type = "geometry_msgs/msg/PoseStamped";
  Header header = {};
  Pose pose = {};
};

struct Path {
  static constexpr std::string_view type = "nav_msgs/msg/Path";
  Header header = {};
  std::vector<PoseStamped> poses = {};
};

/// A point of a cloud, as it lies in the message.
struct PointXyz {
  float x = 0, y = 0, z = 0;
};

/// Unordered points with no field but x, y, z, all finite: written as one row, "is_dense".
struct PointCloud2 {
  static constexpr std::string_view type = "sensor_msgs/msg/PointCloud2";
  Header header = {};
  std::vector<PointXyz> points = {};
};

/// What a marker shows, and what `scale` says of it.
enum class MarkerType : std::int32_t {
  sphere = 2,            ///< diameters along x, y, z
  line_strip = 4,        ///< x: the line's width; through all points
  line_list = 5,         ///< x: the line's width; between points 0 and 1, 2 and 3, …
  text_view_facing = 9,  ///< z: the height of a capital letter
  triangle_list = 11     ///< a factor along each axis; of points 0, 1, 2, then 3, 4, 5, …
};

enum class MarkerAction : std::int32_t { add = 0, remove = 2, remove_all = 3 };

/// (ns, id) names it: one of the same name replaces it.
struct Marker {
  Header header = {};
  std::string ns = {};
  std::int32_t id = 0;
  MarkerType type = MarkerType::sphere;
  MarkerAction action = MarkerAction::add;
  Pose pose = {};
  Vector3 scale = {};
  ColorRGBA color = {};
  std::uint64_t lifetime_ns = 0;   ///< 0: until removed
  std::vector<Point> points = {};  ///< of lines and triangles, relative to `pose`
  std::string text = {};
};

struct MarkerArray {
  static constexpr std::string_view type = "visualization_msgs/msg/MarkerArray";
  std::vector<Marker> markers = {};
};

std::string encode(const String& message);
std::string encode(const Float64& message);
std::string encode(const PoseStamped& message);
std::string encode(const Path& message);
std::string encode(const PointCloud2& message);
std::string encode(const MarkerArray& message);

/// The definition of a message above and of all that it is made of, in the format that MCAP calls
/// "ros2msg" (MCAP specification, Registry, ros2msg).
std::string schema_text(std::string_view type);

}  // namespace arcbid::ros
