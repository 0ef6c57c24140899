// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.hpp"
#include "sim/mcap/ros_types.hpp"

namespace arcbid::ros {
namespace {

struct Definition {
  std::string_view name;
  std::vector<std::string_view> made_of;
  std::string_view fields;
};

const std::vector<Definition> definitions = {
    {"builtin_interfaces/Time", {}, "int32 sec\nuint32 nanosec\n"},
    {"builtin_interfaces/Duration", {}, "int32 sec\nuint32 nanosec\n"},
    {"std_msgs/Header",
     {"builtin_interfaces/Time"},
     "builtin_interfaces/Time stamp\nstring frame_id\n"},
    {"std_msgs/ColorRGBA", {}, "float32 r\nfloat32 g\nfloat32 b\nfloat32 a\n"},
    {"std_msgs/String", {}, "string data\n"},
    {"std_msgs/Float64", {}, "float64 data\n"},
    {"geometry_msgs/Point", {}, "float64 x\nfloat64 y\nfloat64 z\n"},
    {"geometry_msgs/Vector3", {}, "float64 x\nfloat64 y\nfloat64 z\n"},
    {"geometry_msgs/Quaternion", {}, "float64 x 0\nfloat64 y 0\nfloat64 z 0\nfloat64 w 1\n"},
    {"geometry_msgs/Pose",
     {"geometry_msgs/Point", "geometry_msgs/Quaternion"},
     "geometry_msgs/Point position\ngeometry_msgs/Quaternion orientation\n"},
    {"geometry_msgs/PoseStamped",
     {"std_msgs/Header", "geometry_msgs/Pose"},
     "std_msgs/Header header\ngeometry_msgs/Pose pose\n"},
    {"nav_msgs/Path",
     {"std_msgs/Header", "geometry_msgs/PoseStamped"},
     "std_msgs/Header header\ngeometry_msgs/PoseStamped[] poses\n"},
    {"sensor_msgs/PointField", {}, R"(uint8 INT8=1
uint8 UINT8=2
uint8 INT16=3
uint8 UINT16=4
uint8 INT32=5
uint8 UINT32=6
uint8 FLOAT32=7
uint8 FLOAT64=8
string name
uint32 offset
uint8 datatype
uint32 count
)"},
    {"sensor_msgs/PointCloud2",
     {"std_msgs/Header", "sensor_msgs/PointField"},
     R"(std_msgs/Header header
uint32 height
uint32 width
sensor_msgs/PointField[] fields
bool is_bigendian
uint32 point_step
uint32 row_step
uint8[] data
bool is_dense
)"},
    {"sensor_msgs/CompressedImage",
     {"std_msgs/Header"},
     "std_msgs/Header header\nstring format\nuint8[] data\n"},
    {"visualization_msgs/UVCoordinate", {}, "float32 u\nfloat32 v\n"},
    {"visualization_msgs/MeshFile", {}, "string filename\nuint8[] data\n"},
    {"visualization_msgs/Marker",
     {"std_msgs/Header", "geometry_msgs/Pose", "geometry_msgs/Vector3", "std_msgs/ColorRGBA",
      "builtin_interfaces/Duration", "geometry_msgs/Point", "sensor_msgs/CompressedImage",
      "visualization_msgs/UVCoordinate", "visualization_msgs/MeshFile"},
     R"(int32 ARROW=0
int32 CUBE=1
int32 SPHERE=2
int32 CYLINDER=3
int32 LINE_STRIP=4
int32 LINE_LIST=5
int32 CUBE_LIST=6
int32 SPHERE_LIST=7
int32 POINTS=8
int32 TEXT_VIEW_FACING=9
int32 MESH_RESOURCE=10
int32 TRIANGLE_LIST=11
int32 ADD=0
int32 MODIFY=0
int32 DELETE=2
int32 DELETEALL=3
std_msgs/Header header
string ns
int32 id
int32 type
int32 action
geometry_msgs/Pose pose
geometry_msgs/Vector3 scale
std_msgs/ColorRGBA color
builtin_interfaces/Duration lifetime
bool frame_locked
geometry_msgs/Point[] points
std_msgs/ColorRGBA[] colors
string texture_resource
sensor_msgs/CompressedImage texture
visualization_msgs/UVCoordinate[] uv_coordinates
string text
string mesh_resource
visualization_msgs/MeshFile mesh_file
bool mesh_use_embedded_materials
)"},
    {"visualization_msgs/MarkerArray",
     {"visualization_msgs/Marker"},
     "visualization_msgs/Marker[] markers\n"},
};

const Definition& find(std::string_view name) {
  const auto found = std::find_if(definitions.begin(), definitions.end(),
                                  [&](const Definition& d) { return d.name == name; });
  check(found != definitions.end(), "a ROS type whose definition is known");
  return *found;
}

/// Appends what `definition` is made of, each once.
void collect(const Definition& definition, std::vector<const Definition*>& parts) {
  for (const std::string_view name : definition.made_of) {
    const Definition& part = find(name);
    if (std::find(parts.begin(), parts.end(), &part) != parts.end()) continue;
    parts.push_back(&part);
    collect(part, parts);
  }
}

}  // namespace

std::string schema_text(std::string_view type) {
  std::string name(type);
  if (const std::size_t at = name.find("/msg/"); at != std::string::npos) name.erase(at, 4);
  const Definition& message = find(name);
  std::vector<const Definition*> parts;
  collect(message, parts);
  std::string text(message.fields);
  for (const Definition* part : parts) {
    text += std::string(80, '=') + "\nMSG: ";
    text.append(part->name).append("\n").append(part->fields);
  }
  return text;
}

}  // namespace arcbid::ros
