// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/structure_reader.hpp"

/// Small files made on the spot, one writer a format, and what a reader says of them.
namespace arcbid::samples {

/// The eight corners of a box of 20 by 10 by 5 around (0, 0, 2.5); exact in a float.
std::vector<Vec3> box();

/// Its twelve triangles, as corners of box().
std::vector<std::array<std::uint32_t, 3>> box_triangles();

/// A file in the test's temporary directory, removed with the object.
class File {
 public:
  File(const std::string& name, std::string_view bytes);
  ~File();
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Writes, reads, removes.
StructureInput read(const std::string& name, std::string_view bytes,
                    const ReadOptions& options = {});

/// The InputError's one line, without the directory; fails the test when the file is read.
std::string error(const std::string& name, std::string_view bytes, const ReadOptions& options = {});

/// The warnings, joined by '\n'.
std::string warnings(const StructureInput& input);

std::string xyz(const std::vector<Vec3>& points);
std::string pcd(const std::vector<Vec3>& points, const std::string& encoding);
std::string ply(const std::string& encoding, bool with_faces = true);
std::string obj();
std::string stl(bool text);

struct LasLayout {
  int minor = 2;
  int format = 3;
  double scale = 0.01;
  Vec3 offset = Vec3::Zero();
};
std::string las(const std::vector<Vec3>& points, const LasLayout& layout = {});

/// Overwrites the bytes at `offset` by those of `value`.
template <class T>
void put(std::string& bytes, std::size_t offset, T value) {
  bytes.replace(offset, sizeof value, reinterpret_cast<const char*>(&value), sizeof value);
}

template <class T>
void append(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace arcbid::samples
