// SPDX-License-Identifier: GPL-3.0-or-later
// Format: 3D Systems, "Stereolithography Interface Specification", 1989.
#include "core/io/readers/binary.hpp"
#include "core/io/readers/decoders.hpp"
#include "core/io/readers/sniff.hpp"
#include "core/io/readers/text.hpp"

namespace arcbid::readers {
namespace {

void close_facet(RawGeometry& raw) {
  const auto end = static_cast<std::uint32_t>(raw.points.size());
  raw.triangles.push_back({end - 3, end - 2, end - 1});
}

void read_text(const Source& source, RawGeometry& raw) {
  Lines lines(source.bytes);
  std::size_t corners = 0;
  bool open = false, closed_solid = false;
  for (auto line = lines.next(); line; line = lines.next()) {
    std::string_view rest = *line;
    const std::string key = lower_case(next_word(rest));
    if (key == "facet") {
      if (open) fail_at(source, lines.number(), "a facet inside a facet");
      open = true;
      corners = 0;
    } else if (key == "vertex") {
      if (!open || ++corners > 3) {
        fail_at(source, lines.number(), "a vertex outside a facet, or the fourth of one");
      }
      Vec3 point;
      for (int axis = 0; axis < 3; ++axis) {
        point[axis] = require_number(source, lines.number(), next_word(rest));
      }
      raw.points.push_back(point);
    } else if (key == "endfacet") {
      if (!open || corners != 3) {
        fail_at(source, lines.number(), "a facet of {}: legal is 3", counted(corners, "corner"));
      }
      close_facet(raw);
      open = false;
    } else if (key == "endsolid") {
      closed_solid = true;
    }
  }
  if (open || !closed_solid) {
    fail(source, "truncated: no endsolid line; found {}",
         counted(raw.triangles.size(), "triangle"));
  }
}

void read_binary(const Source& source, RawGeometry& raw) {
  if (source.bytes.size() < kStlHeaderBytes) {
    fail(source, "truncated: a binary STL has a header of {} bytes, the file has {}",
         kStlHeaderBytes, source.bytes.size());
  }
  const std::uint64_t count = load_le<std::uint32_t>(source.bytes, kStlHeaderBytes - 4);
  const std::uint64_t whole = (source.bytes.size() - kStlHeaderBytes) / kStlFacetBytes;
  if (whole < count) {
    fail(source, "truncated: the header promises {}, the file holds {}", counted(count, "triangle"),
         grouped(whole));
  }
  raw.points.reserve(3 * count);
  raw.triangles.reserve(count);
  for (std::uint64_t facet = 0; facet < count; ++facet) {
    constexpr std::size_t kNormalBytes = 12;
    const std::size_t first = kStlHeaderBytes + facet * kStlFacetBytes + kNormalBytes;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      Vec3 point;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        point[static_cast<int>(axis)] =
            load_le<float>(source.bytes, first + (3 * corner + axis) * sizeof(float));
      }
      raw.points.push_back(point);
    }
    close_facet(raw);
  }
}

}  // namespace

RawGeometry decode_stl(const Source& source) {
  RawGeometry raw;
  raw.repeats_vertices = true;
  if (is_text_stl(source.bytes)) {
    read_text(source, raw);
  } else {
    read_binary(source, raw);
  }
  if (raw.triangles.empty()) fail(source, "an STL file without a triangle");
  return raw;
}

}  // namespace arcbid::readers
