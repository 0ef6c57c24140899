// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/mcap/ros_types.hpp"

#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>
#include <fastcdr/exceptions/NotEnoughMemoryException.h>

#include <array>
#include <bit>
#include <cstddef>

namespace arcbid::ros {
namespace {

using eprosima::fastcdr::Cdr;
using eprosima::fastcdr::FastBuffer;

static_assert(sizeof(PointXyz) == 12 && std::endian::native == std::endian::little,
              "points are copied into the message as they are");

template <class Sequence>
void put_length(Cdr& cdr, const Sequence& sequence) {
  cdr << static_cast<std::uint32_t>(sequence.size());
}

/// A sequence that nothing here has anything for.
void put_none(Cdr& cdr) {
  cdr << std::uint32_t{0};
}

/// Time and Duration.
void put_seconds(Cdr& cdr, std::uint64_t ns) {
  constexpr std::uint64_t second = 1'000'000'000;
  cdr << static_cast<std::int32_t>(ns / second) << static_cast<std::uint32_t>(ns % second);
}

void put(Cdr& cdr, const Header& header) {
  put_seconds(cdr, header.stamp_ns);
  cdr << header.frame_id;
}

void put(Cdr& cdr, const Point& point) {
  cdr << point.x << point.y << point.z;
}

void put(Cdr& cdr, const Pose& pose) {
  put(cdr, pose.position);
  const Quaternion& q = pose.orientation;
  cdr << q.x << q.y << q.z << q.w;
}

void put(Cdr& cdr, const ColorRGBA& color) {
  cdr << color.r << color.g << color.b << color.a;
}

void put(Cdr& cdr, const String& message) {
  cdr << message.data;
}

void put(Cdr& cdr, const Float64& message) {
  cdr << message.data;
}

void put(Cdr& cdr, const PoseStamped& message) {
  put(cdr, message.header);
  put(cdr, message.pose);
}

void put(Cdr& cdr, const Marker& marker);

template <class Element>
void put(Cdr& cdr, const std::vector<Element>& sequence) {
  put_length(cdr, sequence);
  for (const Element& element : sequence) put(cdr, element);
}

void put(Cdr& cdr, const Path& message) {
  put(cdr, message.header);
  put(cdr, message.poses);
}

void put_point_fields(Cdr& cdr) {
  constexpr std::uint8_t float32 = 7;
  constexpr std::array names = {"x", "y", "z"};
  put_length(cdr, names);
  std::uint32_t offset = 0;
  for (const char* name : names) {
    cdr << std::string(name) << offset << float32 << std::uint32_t{1};
    offset += sizeof(float);
  }
}

void put(Cdr& cdr, const PointCloud2& message) {
  constexpr std::uint32_t height = 1, point_step = sizeof(PointXyz);
  constexpr bool is_bigendian = false, is_dense = true;
  const auto width = static_cast<std::uint32_t>(message.points.size());
  const std::uint32_t row_step = width * point_step;
  put(cdr, message.header);
  cdr << height << width;
  put_point_fields(cdr);
  cdr << is_bigendian << point_step << row_step;
  cdr << row_step;  // the data's length
  cdr.serializeArray(reinterpret_cast<const std::uint8_t*>(message.points.data()), row_step);
  cdr << is_dense;
}

void put_no_texture(Cdr& cdr) {
  const std::string none;
  cdr << none;         // texture_resource
  put(cdr, Header{});  // texture: a CompressedImage
  cdr << none;
  put_none(cdr);
  put_none(cdr);  // uv_coordinates
}

void put_no_mesh(Cdr& cdr) {
  const std::string none;
  cdr << none << none;  // mesh_resource; mesh_file: its name
  put_none(cdr);        // and its data
  cdr << false;         // mesh_use_embedded_materials
}

void put(Cdr& cdr, const Marker& marker) {
  put(cdr, marker.header);
  cdr << marker.ns << marker.id;
  cdr << static_cast<std::int32_t>(marker.type) << static_cast<std::int32_t>(marker.action);
  put(cdr, marker.pose);
  put(cdr, marker.scale);
  put(cdr, marker.color);
  put_seconds(cdr, marker.lifetime_ns);
  cdr << false;  // frame_locked
  put(cdr, marker.points);
  put_none(cdr);  // colors: one for each point
  put_no_texture(cdr);
  cdr << marker.text;
  put_no_mesh(cdr);
}

void put(Cdr& cdr, const MarkerArray& message) {
  put(cdr, message.markers);
}

/// Fast CDR steps over padding without writing it, and its own buffer starts with whatever was
/// there. So it writes into zeros of ours, and into more of them if they were too few.
template <class Message>
std::string encode_into_zeros(const Message& message, std::size_t guess) {
  for (std::string bytes(guess, '\0');; bytes.assign(2 * bytes.size(), '\0')) {
    try {
      FastBuffer buffer(bytes.data(), bytes.size());
      Cdr cdr(buffer, Cdr::LITTLE_ENDIANNESS, Cdr::DDS_CDR);
      cdr.serialize_encapsulation();
      put(cdr, message);
      bytes.resize(cdr.getSerializedDataLength());
      return bytes;
    } catch (const eprosima::fastcdr::exception::NotEnoughMemoryException&) {
    }
  }
}

}  // namespace

std::string encode(const String& message) {
  return encode_into_zeros(message, 16 + message.data.size());
}

std::string encode(const Float64& message) {
  return encode_into_zeros(message, 16);
}

std::string encode(const PoseStamped& message) {
  return encode_into_zeros(message, 128);
}

std::string encode(const Path& message) {
  return encode_into_zeros(message, 128 * (1 + message.poses.size()));
}

std::string encode(const PointCloud2& message) {
  return encode_into_zeros(message, 256 + sizeof(PointXyz) * message.points.size());
}

std::string encode(const MarkerArray& message) {
  return encode_into_zeros(message, 512 * (1 + message.markers.size()));
}

}  // namespace arcbid::ros
