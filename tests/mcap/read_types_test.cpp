// SPDX-License-Identifier: GPL-3.0-or-later
// Each type of message, read with @foxglove's decoders by read_mcap.mjs.
#include <gmock/gmock.h>

#include "tests/mcap/read_back.hpp"

namespace arcbid {
namespace {

using nlohmann::json;

constexpr std::uint64_t second = 1'000'000'000;

class ReadTypes : public mcap_test::ReadBack {};

json pose_json(double x, double y, double z, double qx, double qy, double qz, double qw) {
  return {{"position", {{"x", x}, {"y", y}, {"z", z}}},
          {"orientation", {{"x", qx}, {"y", qy}, {"z", qz}, {"w", qw}}}};
}

// The decoder calls "nanosec" so.
json header_json(std::uint32_t sec, std::uint32_t nsec, const std::string& frame) {
  return {{"stamp", {{"sec", sec}, {"nsec", nsec}}}, {"frame_id", frame}};
}

json points_json(const std::vector<ros::Point>& points) {
  json all = json::array();
  for (const ros::Point& p : points) all.push_back({{"x", p.x}, {"y", p.y}, {"z", p.z}});
  return all;
}

TEST_P(ReadTypes, String) {
  EXPECT_EQ(read_back(ros::String{"agreed, ≥ 4 agents"}), json({{"data", "agreed, ≥ 4 agents"}}));
}

TEST_P(ReadTypes, Float64) {
  EXPECT_EQ(read_back(ros::Float64{0.1}), json({{"data", 0.1}}));
}

TEST_P(ReadTypes, PoseStamped) {
  const ros::PoseStamped pose{{7 * second + 5, "map"}, {{1.5, -2.5, 3.25}, {0.5, -0.5, 0.5, 0.25}}};
  EXPECT_EQ(read_back(pose), json({{"header", header_json(7, 5, "map")},
                                   {"pose", pose_json(1.5, -2.5, 3.25, 0.5, -0.5, 0.5, 0.25)}}));
}

// Frames of different lengths, so that each pose needs other padding.
TEST_P(ReadTypes, Path) {
  ros::Path path{{second, "map"}, {}};
  json poses = json::array();
  for (std::uint32_t i = 0; i < 9; ++i) {
    const std::string frame(i, 'f');
    path.poses.push_back({{i * second + i, frame}, {{i + 0.5, 1, 2}, {}}});
    poses.push_back(
        {{"header", header_json(i, i, frame)}, {"pose", pose_json(i + 0.5, 1, 2, 0, 0, 0, 1)}});
  }
  EXPECT_EQ(read_back(path), json({{"header", header_json(1, 0, "map")}, {"poses", poses}}));
}

TEST_P(ReadTypes, PathOfNothing) {
  EXPECT_EQ(read_back(ros::Path{{0, "map"}, {}}),
            json({{"header", header_json(0, 0, "map")}, {"poses", json::array()}}));
}

json field_json(const std::string& name, int offset) {
  constexpr int float32 = 7;
  return {{"name", name}, {"offset", offset}, {"datatype", float32}, {"count", 1}};
}

TEST_P(ReadTypes, PointCloud2) {
  const std::vector<ros::PointXyz> points = {{1.5F, -2.25F, 3}, {0.1F, 1e6F, -0.0F}};
  const json cloud = read_back(ros::PointCloud2{{2 * second + 3, "bridge"}, points});
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(points.data());
  EXPECT_EQ(cloud, json({{"header", header_json(2, 3, "bridge")},
                         {"height", 1},
                         {"width", 2},
                         {"fields", {field_json("x", 0), field_json("y", 4), field_json("z", 8)}},
                         {"is_bigendian", false},
                         {"point_step", 12},
                         {"row_step", 24},
                         {"data", {{"length", 24}, {"first", std::vector<int>(bytes, bytes + 24)}}},
                         {"is_dense", true}}));
}

TEST_P(ReadTypes, PointCloud2LargerThanAChunk) {
  const json cloud = read_back(ros::PointCloud2{{0, "bridge"}, {10'000, ros::PointXyz{1, 2, 3}}});
  EXPECT_EQ(cloud.at("width"), 10'000);
  EXPECT_EQ(cloud.at("data").at("length"), 120'000);
}

/// What no marker of ours has.
json bare_marker() {
  const json no_bytes = {{"length", 0}, {"first", json::array()}};
  return {{"frame_locked", false},
          {"colors", json::array()},
          {"texture_resource", ""},
          {"texture", {{"header", header_json(0, 0, "")}, {"format", ""}, {"data", no_bytes}}},
          {"uv_coordinates", json::array()},
          {"mesh_resource", ""},
          {"mesh_file", {{"filename", ""}, {"data", no_bytes}}},
          {"mesh_use_embedded_materials", false}};
}

json marker_json(const ros::Marker& marker, std::uint32_t sec, int type, int action,
                 const json& pose) {
  json all = bare_marker();
  all["header"] = header_json(sec, 0, marker.header.frame_id);
  all["ns"] = marker.ns;
  all["id"] = marker.id;
  all["type"] = type;
  all["action"] = action;
  all["pose"] = pose;
  all["scale"] = points_json({marker.scale})[0];
  const ros::ColorRGBA& c = marker.color;
  all["color"] = {{"r", c.r}, {"g", c.g}, {"b", c.b}, {"a", c.a}};
  all["lifetime"] = {{"sec", marker.lifetime_ns / second}, {"nsec", marker.lifetime_ns % second}};
  all["points"] = points_json(marker.points);
  all["text"] = marker.text;
  return all;
}

TEST_P(ReadTypes, MarkerArrayOfEveryKind) {
  using ros::MarkerAction;
  using ros::MarkerType;
  const ros::Marker sphere{.header = {second, "map"},
                           .ns = "homes",
                           .id = 3,
                           .pose = {{1, 2, 3}, {0.5, 0.5, -0.5, 0.5}},
                           .scale = {0.25, 0.5, 0.75},
                           .color = {1, 0.5F, 0.25F, 0.125F},
                           .lifetime_ns = 2 * second + 17};
  const ros::Marker strip{.header = {2 * second, "m"},
                          .ns = "route",
                          .type = MarkerType::line_strip,
                          .scale = {0.125, 0, 0},
                          .points = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}};
  const ros::Marker list{.header = {3 * second, "map"},
                         .ns = "arcs",
                         .id = -1,
                         .type = MarkerType::line_list,
                         .points = {{0, 0, 0.5}, {0, 0, 1}}};
  const ros::Marker text{.header = {4 * second, ""},
                         .ns = "names",
                         .id = 9,
                         .type = MarkerType::text_view_facing,
                         .scale = {0, 0, 2},
                         .text = "agent 9"};
  const ros::Marker triangles{.ns = "structure",
                              .type = MarkerType::triangle_list,
                              .scale = {1, 1, 1},
                              .points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  const ros::Marker removed{.ns = "homes", .id = 3, .action = MarkerAction::remove};
  const ros::Marker all_removed{.action = MarkerAction::remove_all};
  const json upright = pose_json(0, 0, 0, 0, 0, 0, 1);
  EXPECT_EQ(
      read_back(ros::MarkerArray{{sphere, strip, list, text, triangles, removed, all_removed}}),
      json({{"markers",
             {marker_json(sphere, 1, 2, 0, pose_json(1, 2, 3, 0.5, 0.5, -0.5, 0.5)),
              marker_json(strip, 2, 4, 0, upright), marker_json(list, 3, 5, 0, upright),
              marker_json(text, 4, 9, 0, upright), marker_json(triangles, 0, 11, 0, upright),
              marker_json(removed, 0, 2, 2, upright),
              marker_json(all_removed, 0, 2, 3, upright)}}}));
}

INSTANTIATE_TEST_SUITE_P(Compressions, ReadTypes,
                         testing::Values(mcap::Compression::none, mcap::Compression::zstd),
                         [](const auto& of) { return of.index == 0 ? "none" : "zstd"; });

}  // namespace
}  // namespace arcbid
