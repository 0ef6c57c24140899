// SPDX-License-Identifier: GPL-3.0-or-later
// Format: ASPRS "LAS Specification 1.4 - R15", tables 3 to 20; key numbers: GeoTIFF 1.0.
#include <algorithm>
#include <array>
#include <cmath>

#include "core/io/readers/binary.hpp"
#include "core/io/readers/decoders.hpp"
#include "core/io/readers/sniff.hpp"
#include "core/io/readers/text.hpp"

namespace arcbid::readers {
namespace {

struct Header {
  std::uint64_t header_size = 0, first_point = 0, variable_records = 0, points = 0;
  std::uint32_t format = 0, stride = 0;
  Vec3 scale, offset;
};

/// What the variable length records say of the coordinate system.
struct Projection {
  bool geographic = false;
  std::optional<std::string_view> unit;
};

constexpr std::array<std::uint32_t, 11> kLeastStride{20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};

void read_layout(const Source& source, Header& header) {
  const std::string_view bytes = source.bytes;
  const std::uint8_t major = load_le<std::uint8_t>(bytes, 24);
  const std::uint8_t minor = load_le<std::uint8_t>(bytes, 25);
  if (major != 1 || minor > 4)
    fail(source, "LAS version {}.{}: legal are 1.0 to 1.4", major, minor);
  header.header_size = load_le<std::uint16_t>(bytes, 94);
  header.first_point = load_le<std::uint32_t>(bytes, 96);
  header.variable_records = load_le<std::uint32_t>(bytes, 100);
  header.format = load_le<std::uint8_t>(bytes, 104);
  header.stride = load_le<std::uint16_t>(bytes, 105);
  header.points = load_le<std::uint32_t>(bytes, 107);
  const std::uint64_t least_header = minor == 4 ? 375 : 227;
  if (header.header_size < least_header) {
    fail(source, "LAS header size {}: legal is {} or more", header.header_size, least_header);
  }
  if (header.first_point < header.header_size || header.first_point > bytes.size()) {
    fail(source, "truncated or damaged: the points start at byte {}, the file has {} bytes",
         grouped(header.first_point), grouped(bytes.size()));
  }
  if (minor == 4) {
    const auto points = load_le<std::uint64_t>(bytes, 247);
    if (points != 0) header.points = points;
  }
}

void check_points(const Source& source, const Header& header) {
  if (header.format >= kLeastStride.size()) {
    fail(source, "LAS point format {}: legal are 0 to 10", header.format);
  }
  if (header.stride < kLeastStride[header.format]) {
    fail(source, "LAS point record length {}: point format {} has {} or more", header.stride,
         header.format, kLeastStride[header.format]);
  }
  for (int axis = 0; axis < 3; ++axis) {
    const double scale = header.scale[axis];
    if (!std::isfinite(scale) || scale == 0 || !std::isfinite(header.offset[axis])) {
      fail(source, "LAS {} scale factor {} and offset {}: legal are finite numbers, scale not 0",
           "xyz"[axis], scale, header.offset[axis]);
    }
  }
  const std::uint64_t whole = (source.bytes.size() - header.first_point) / header.stride;
  if (whole < header.points) {
    fail(source, "truncated: the header promises {}, the file holds {}",
         counted(header.points, "point"), grouped(whole));
  }
}

/// GeoTIFF keys: 1024 model type (2 = geographic), 3076 linear unit (9002 foot, 9003 US survey
/// foot).
void read_geotiff_keys(std::string_view data, Projection& projection) {
  for (std::size_t at = 8; at + 8 <= data.size(); at += 8) {
    const auto key = load_le<std::uint16_t>(data, at), value = load_le<std::uint16_t>(data, at + 6);
    if (load_le<std::uint16_t>(data, at + 2) != 0) continue;  // the value stands in another record
    if (key == 1024) projection.geographic = value == 2;
    if (key == 3076 && value == 9001) projection.unit = "m";
    if (key == 3076 && value == 9002) projection.unit = "ft";
    if (key == 3076 && value == 9003) projection.unit = "us-ft";
  }
}

void read_wkt(std::string_view data, Projection& projection) {
  const std::string wkt = lower_case(data.substr(0, std::min<std::size_t>(data.size(), 1 << 16)));
  const auto says = [&](std::string_view text) { return wkt.find(text) != std::string::npos; };
  const bool projected = says("projcs") || says("projcrs");
  if (!projected && (says("geogcs") || says("geogcrs"))) projection.geographic = true;
  if (!projected) return;
  if (says("us survey foot") || says("foot_us") || says("us_foot")) {
    projection.unit = "us-ft";
  } else if (says("\"foot\"") || says("international foot")) {
    projection.unit = "ft";
  } else if (says("\"metre\"") || says("\"meter\"")) {
    projection.unit = "m";
  }
}

/// Walks the variable length records; refuses LASzip's.
Projection read_records(const Source& source, const Header& header) {
  constexpr std::size_t kRecordHeader = 54;
  constexpr std::uint16_t kGeoTiffKeys = 34735, kWkt = 2112;
  Projection projection;
  std::uint64_t at = header.header_size;
  for (std::uint64_t i = 0; i < header.variable_records; ++i) {
    if (at + kRecordHeader > header.first_point) break;
    const std::string_view user = source.bytes.substr(at + 2, 16);
    const auto id = load_le<std::uint16_t>(source.bytes, at + 18);
    const std::uint64_t length = load_le<std::uint16_t>(source.bytes, at + 20);
    at += kRecordHeader;
    if (at + length > header.first_point) break;
    const std::string_view data = source.bytes.substr(at, length);
    if (user.starts_with("laszip encoded")) refuse_laz(source);
    if (user.starts_with("LASF_Projection") && id == kGeoTiffKeys) {
      read_geotiff_keys(data, projection);
    } else if (user.starts_with("LASF_Projection") && id == kWkt) {
      read_wkt(data, projection);
    }
    at += length;
  }
  return projection;
}

/// A point that its own flags call deleted (withheld) or noise (classes 7 and 18).
bool is_noise(std::string_view bytes, std::uint64_t at, std::uint32_t format) {
  const auto flags = load_le<std::uint8_t>(bytes, at + 15);
  if (format < 6) return (flags & 0x80) != 0 || (flags & 0x1f) == 7;
  const auto classification = load_le<std::uint8_t>(bytes, at + 16);
  return (flags & 0x04) != 0 || classification == 7 || classification == 18;
}

void read_points(const Source& source, const Header& header, RawGeometry& raw) {
  raw.points.reserve(header.points);
  std::uint64_t noise = 0;
  for (std::uint64_t i = 0; i < header.points; ++i) {
    const std::uint64_t at = header.first_point + i * header.stride;
    if (is_noise(source.bytes, at, header.format)) {
      ++noise;
      continue;
    }
    Vec3 point;
    for (int axis = 0; axis < 3; ++axis) {
      const auto steps =
          load_le<std::int32_t>(source.bytes, at + 4 * static_cast<std::uint64_t>(axis));
      point[axis] = steps * header.scale[axis] + header.offset[axis];
    }
    raw.points.push_back(point);
  }
  if (noise > 0) {
    raw.warnings.push_back("dropped " + counted(noise, "point") +
                           " that the file itself marks as withheld or noise");
  }
}

}  // namespace

RawGeometry decode_las(const Source& source) {
  constexpr std::size_t kLeastHeader = 227;
  if (source.bytes.size() < kLeastHeader) {
    fail(source, "truncated: a LAS header has {} bytes, the file has {}", kLeastHeader,
         source.bytes.size());
  }
  Header header;
  // LASzip marks the point format with the high bits; the rest of such a header may be unusual too.
  if ((load_le<std::uint8_t>(source.bytes, 104) & 0xc0) != 0) refuse_laz(source);
  read_layout(source, header);
  for (int axis = 0; axis < 3; ++axis) {
    const auto step = 8 * static_cast<std::size_t>(axis);
    header.scale[axis] = load_le<double>(source.bytes, 131 + step);
    header.offset[axis] = load_le<double>(source.bytes, 155 + step);
  }
  const Projection projection = read_records(source, header);
  check_points(source, header);
  RawGeometry raw;
  raw.declared_unit = projection.unit;
  read_points(source, header, raw);
  raw.in_degrees = projection.geographic;
  return raw;
}

}  // namespace arcbid::readers
