// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/readers/samples.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

#include "core/base/error.hpp"

namespace arcbid::samples {

std::vector<Vec3> box() {
  std::vector<Vec3> points;
  for (int i = 0; i < 8; ++i) {
    points.emplace_back(i & 1 ? 10 : -10, i & 2 ? 5 : -5, i & 4 ? 5 : 0);
  }
  return points;
}

std::vector<std::array<std::uint32_t, 3>> box_triangles() {
  return {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
          {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
}

namespace {

/// Made once and removed when the program ends.
struct Folder {
  std::filesystem::path path =
      std::filesystem::path(testing::TempDir()) / ("arcbid_readers_" + std::to_string(getpid()));
  Folder() { std::filesystem::create_directories(path); }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove(path, ignored);
  }
};

}  // namespace

File::File(const std::string& name, std::string_view bytes) {
  static const Folder folder;
  path_ = folder.path / name;
  std::ofstream(path_, std::ios::binary)
      .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

File::~File() {
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

StructureInput read(const std::string& name, std::string_view bytes, const ReadOptions& options) {
  const File file(name, bytes);
  return read_structure(file.path(), options);
}

std::string error(const std::string& name, std::string_view bytes, const ReadOptions& options) {
  const File file(name, bytes);
  try {
    read_structure(file.path(), options);
  } catch (const InputError& e) {
    std::string text = e.what();
    EXPECT_EQ(text.find('\n'), text.npos) << text;
    const std::string folder = file.path().parent_path().string() + "/";
    for (auto at = text.find(folder); at != text.npos; at = text.find(folder)) {
      text.erase(at, folder.size());
    }
    return text;
  }
  ADD_FAILURE() << name << " was read";
  return "";
}

std::string warnings(const StructureInput& input) {
  std::string text;
  for (const auto& warning : input.warnings) text += warning + "\n";
  return text;
}

std::string xyz(const std::vector<Vec3>& points) {
  std::string text;
  for (const Vec3& p : points) text += fmt::format("{} {} {}\n", p.x(), p.y(), p.z());
  return text;
}

std::string pcd(const std::vector<Vec3>& points, const std::string& encoding) {
  std::string bytes = fmt::format(
      "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS intensity x z y\n"
      "SIZE 1 4 8 2\nTYPE U F F I\nCOUNT 3 1 1 1\nWIDTH {}\nHEIGHT 1\n"
      "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS {}\nDATA {}\n",
      points.size(), points.size(), encoding);
  if (encoding == "ascii") {
    for (const Vec3& p : points) bytes += fmt::format("7 8 9 {} {} {}\n", p.x(), p.z(), p.y());
    return bytes;
  }
  if (encoding == "binary") {
    for (const Vec3& p : points) {
      bytes += "abc";
      append(bytes, static_cast<float>(p.x()));
      append(bytes, p.z());
      append(bytes, static_cast<std::int16_t>(p.y()));
    }
    return bytes;
  }
  std::string fields(3 * points.size(), 'i');
  for (const Vec3& p : points) append(fields, static_cast<float>(p.x()));
  for (const Vec3& p : points) append(fields, p.z());
  for (const Vec3& p : points) append(fields, static_cast<std::int16_t>(p.y()));
  // The first field is one byte repeated: a literal and a long self-overlapping copy; the rest
  // goes out in literal runs.
  std::string packed("\x00i", 2);
  std::size_t at = 1;
  if (const std::size_t repeated = 3 * points.size() - 1; repeated >= 9 && repeated <= 264) {
    packed += static_cast<char>(7 << 5);
    packed += static_cast<char>(repeated - 9);
    packed += '\0';
    at += repeated;
  }
  while (at < fields.size()) {
    const std::size_t run = std::min<std::size_t>(32, fields.size() - at);
    packed += static_cast<char>(run - 1);
    packed += fields.substr(at, run);
    at += run;
  }
  append(bytes, static_cast<std::uint32_t>(packed.size()));
  append(bytes, static_cast<std::uint32_t>(fields.size()));
  return bytes + packed;
}

namespace {

/// One value of a PLY body, in the byte order of its encoding.
template <class T>
void ply_value(std::string& bytes, const std::string& encoding, T value) {
  if (encoding == "ascii") {
    bytes += fmt::format("{} ", value);
    return;
  }
  std::string raw;
  append(raw, value);
  if (encoding == "binary_big_endian") std::reverse(raw.begin(), raw.end());
  bytes += raw;
}

}  // namespace

std::string ply(const std::string& encoding, bool with_faces) {
  std::string bytes = "ply\nformat " + encoding +
                      " 1.0\ncomment made by a test\nelement vertex 8\nproperty float x\n"
                      "property uchar red\nproperty double y\nproperty int z\n";
  if (with_faces) {
    bytes += "element face 12\nproperty list uchar int vertex_indices\nproperty short group\n";
  }
  bytes += "end_header\n";
  const std::string line_end = encoding == "ascii" ? "\n" : "";
  for (const Vec3& p : box()) {
    ply_value(bytes, encoding, static_cast<float>(p.x()));
    ply_value(bytes, encoding, std::uint8_t{200});
    ply_value(bytes, encoding, p.y());
    ply_value(bytes, encoding, static_cast<std::int32_t>(p.z()));
    bytes += line_end;
  }
  if (!with_faces) return bytes;
  for (const auto& triangle : box_triangles()) {
    ply_value(bytes, encoding, std::uint8_t{3});
    for (const auto corner : triangle) {
      ply_value(bytes, encoding, static_cast<std::int32_t>(corner));
    }
    ply_value(bytes, encoding, std::int16_t{-1});
    bytes += line_end;
  }
  return bytes;
}

std::string obj() {
  std::string text = "# a box\nmtllib box.mtl\no box\n";
  for (const Vec3& p : box()) text += fmt::format("v {} {} {}\n", p.x(), p.y(), p.z());
  text += "vt 0 0\nvn 0 0 1\nusemtl steel\ns off\n";
  for (const auto& t : box_triangles()) {
    text += fmt::format("f {}/1/1 {}//1 {}\n", t[0] + 1, t[1] + 1, static_cast<int>(t[2]) - 8);
  }
  return text;
}

std::string stl(bool text) {
  const auto points = box();
  std::string bytes =
      text ? "solid box\n" : "solid in name only, with a facet" + std::string(48, ' ');
  if (!text) append(bytes, std::uint32_t{12});
  for (const auto& triangle : box_triangles()) {
    if (text) bytes += " facet normal 0 0 0\n  outer loop\n";
    if (!text) bytes += std::string(12, '\0');
    for (const auto corner : triangle) {
      const Vec3& p = points[corner];
      if (text) bytes += fmt::format("   vertex {} {} {:e}\n", p.x(), p.y(), p.z());
      for (int axis = 0; !text && axis < 3; ++axis) append(bytes, static_cast<float>(p[axis]));
    }
    bytes += text ? "  endloop\n endfacet\n" : std::string(2, '\0');
  }
  return text ? bytes + "endsolid box\n" : bytes;
}

std::string las(const std::vector<Vec3>& points, const LasLayout& layout) {
  constexpr int kStride[] = {20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};
  const std::size_t header_size = layout.minor == 4 ? 375 : 227;
  std::string bytes(header_size, '\0');
  bytes.replace(0, 4, "LASF");
  bytes[24] = 1;
  bytes[25] = static_cast<char>(layout.minor);
  put(bytes, 94, static_cast<std::uint16_t>(header_size));
  put(bytes, 96, static_cast<std::uint32_t>(header_size));
  bytes[104] = static_cast<char>(layout.format);
  put(bytes, 105, static_cast<std::uint16_t>(kStride[layout.format]));
  if (layout.minor == 4) {
    put(bytes, 247, static_cast<std::uint64_t>(points.size()));
  } else {
    put(bytes, 107, static_cast<std::uint32_t>(points.size()));
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    put(bytes, 131 + 8 * axis, layout.scale);
    put(bytes, 155 + 8 * axis, layout.offset[static_cast<int>(axis)]);
  }
  for (const Vec3& p : points) {
    std::string record;
    for (int axis = 0; axis < 3; ++axis) {
      append(record, static_cast<std::int32_t>(
                         std::llround((p[axis] - layout.offset[axis]) / layout.scale)));
    }
    record.resize(static_cast<std::size_t>(kStride[layout.format]), '\0');
    bytes += record;
  }
  return bytes;
}

}  // namespace arcbid::samples
