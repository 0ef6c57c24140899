// SPDX-License-Identifier: GPL-3.0-or-later
// Format: "The PCD (Point Cloud Data) file format", pointclouds.org, version 0.7.
#include <array>
#include <limits>
#include <optional>

#include "core/io/readers/binary.hpp"
#include "core/io/readers/decoders.hpp"
#include "core/io/readers/lzf.hpp"
#include "core/io/readers/text.hpp"

namespace arcbid::readers {
namespace {

struct Field {
  std::string name;
  Scalar type;
  std::uint32_t count = 1;
  std::uint64_t offset = 0;  ///< bytes into a point's record
  std::uint64_t column = 0;  ///< first word in a line of ascii data
};

struct Header {
  std::vector<Field> fields;
  std::optional<std::uint64_t> width, height, points;
  std::string data;          ///< ascii | binary | binary_compressed
  std::uint64_t stride = 0;  ///< bytes of one point
  std::array<Field, 3> xyz;
};

/// Limits that no real file reaches and that keep every product below inside 64 bits.
constexpr std::int64_t kMostCount = 1 << 16;
constexpr std::size_t kMostFields = 1024;
constexpr std::int64_t kMostPoints = std::numeric_limits<std::uint32_t>::max();

std::int64_t header_count(const Source& source, std::size_t line, std::string_view key,
                          std::string_view word, std::int64_t most) {
  const auto value = to_integer(word);
  if (!value || *value < 0 || *value > most) {
    fail_at(source, line, "{} {}: legal is a whole number from 0 to {}", key, in_quotes(word),
            grouped(static_cast<std::uint64_t>(most)));
  }
  return *value;
}

/// SIZE, TYPE and COUNT: one value for every field.
void read_field_row(const Source& source, std::size_t line, std::string_view key,
                    const std::vector<std::string_view>& values, Header& header) {
  if (values.size() != header.fields.size()) {
    fail_at(source, line, "{} has {} values, but FIELDS names {}", key, values.size(),
            header.fields.size());
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    Field& field = header.fields[i];
    if (key == "TYPE") {
      field.type.kind = values[i].size() == 1 ? values[i][0] : '?';
    } else {
      const auto value =
          static_cast<std::uint32_t>(header_count(source, line, key, values[i], kMostCount));
      (key == "SIZE" ? field.type.size : field.count) = value;
    }
  }
}

void read_header_line(const Source& source, std::size_t line,
                      const std::vector<std::string_view>& row, Header& header) {
  const std::string_view key = row[0];
  const std::vector<std::string_view> values(row.begin() + 1, row.end());
  if (key == "VERSION" || key == "VIEWPOINT") return;
  if (values.empty()) fail_at(source, line, "{} has no value", in_quotes(key));
  if (key == "FIELDS" || key == "COLUMNS") {
    if (values.size() > kMostFields) fail_at(source, line, "more than {} fields", kMostFields);
    for (const auto name : values) header.fields.push_back({.name = std::string(name), .type = {}});
  } else if (key == "SIZE" || key == "TYPE" || key == "COUNT") {
    read_field_row(source, line, key, values, header);
  } else if (key == "WIDTH") {
    header.width = header_count(source, line, key, values[0], kMostPoints);
  } else if (key == "HEIGHT") {
    header.height = header_count(source, line, key, values[0], kMostPoints);
  } else if (key == "POINTS") {
    header.points = header_count(source, line, key, values[0], kMostPoints);
  } else if (key == "DATA") {
    header.data = values[0];
    if (header.data != "ascii" && header.data != "binary" && header.data != "binary_compressed") {
      fail_at(source, line, "DATA {}: legal are ascii, binary, binary_compressed",
              in_quotes(header.data));
    }
  } else {
    fail_at(source, line, "{} is no header line of a PCD file", in_quotes(key));
  }
}

/// x, y and z by name; X, Y and Z when the lower-case ones are not there.
void find_coordinates(const Source& source, Header& header) {
  std::string names;
  for (const Field& field : header.fields) names += " " + field.name;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string name(1, "xyz"[axis]);
    const Field* found = nullptr;
    for (const Field& field : header.fields) {
      if (field.name == name || (!found && lower_case(field.name) == name)) found = &field;
    }
    if (!found) {
      fail(source, "field {} is missing: the fields are{}", name, in_quotes(names.substr(0, 100)));
    }
    if (found->count != 1) fail(source, "field {}: COUNT {} must be 1", name, found->count);
    header.xyz[axis] = *found;
  }
}

void finish(const Source& source, Header& header) {
  if (header.data.empty()) fail(source, "the PCD header has no DATA line");
  std::uint64_t column = 0;
  for (Field& field : header.fields) {
    if (!field.type.legal()) {
      fail(source, "field {}: TYPE {} of SIZE {}: legal are F 4|8, I and U 1|2|4|8",
           in_quotes(field.name), in_quotes({&field.type.kind, 1}), field.type.size);
    }
    field.offset = header.stride;
    field.column = column;
    header.stride += std::uint64_t{field.type.size} * field.count;
    column += field.count;
  }
  find_coordinates(source, header);
  if (!header.points && !header.width) fail(source, "the PCD header has neither POINTS nor WIDTH");
  const std::uint64_t size = header.width.value_or(*header.points) * header.height.value_or(1);
  if (header.points && header.width && size != *header.points) {
    fail(source, "POINTS {} is not WIDTH {} times HEIGHT {}", *header.points, *header.width,
         header.height.value_or(1));
  }
  if (size > static_cast<std::uint64_t>(kMostPoints)) {
    fail(source, "{} points: legal are up to {}", grouped(size), grouped(kMostPoints));
  }
  header.points = size;
}

Header read_header(const Source& source, Lines& lines) {
  Header header;
  while (header.data.empty()) {
    const auto line = lines.next();
    if (!line) break;
    const auto row = words(*line);
    if (!row.empty() && !row[0].starts_with('#')) {
      read_header_line(source, lines.number(), row, header);
    }
  }
  finish(source, header);
  return header;
}

[[noreturn]] void fail_truncated(const Source& source, std::uint64_t expected,
                                 std::uint64_t found) {
  fail(source, "truncated: the header promises {}, the file holds {}", counted(expected, "point"),
       grouped(found));
}

void read_ascii(const Source& source, const Header& header, Lines& lines, RawGeometry& raw) {
  raw.points.reserve(std::min<std::uint64_t>(*header.points, source.bytes.size() / 6 + 1));
  while (raw.points.size() < *header.points) {
    const auto line = lines.next();
    if (!line) fail_truncated(source, *header.points, raw.points.size());
    std::string_view rest = *line;
    std::string_view word = next_word(rest);
    if (word.empty()) continue;
    Vec3 point;
    int missing = 3;
    for (std::uint64_t column = 0; missing > 0; ++column, word = next_word(rest)) {
      if (word.empty()) {
        fail_at(source, lines.number(), "the line ends before field x, y or z (word {})",
                column + 1);
      }
      for (int axis = 0; axis < 3; ++axis) {
        if (header.xyz[axis].column != column) continue;
        point[axis] = require_number(source, lines.number(), word);
        --missing;
      }
    }
    raw.points.push_back(point);
  }
}

void read_binary(const Source& source, const Header& header, std::string_view data,
                 RawGeometry& raw) {
  const std::uint64_t whole = data.size() / header.stride;
  if (whole < *header.points) fail_truncated(source, *header.points, whole);
  raw.points.reserve(*header.points);
  for (std::uint64_t i = 0; i < *header.points; ++i) {
    Vec3 point;
    for (int axis = 0; axis < 3; ++axis) {
      const Field& field = header.xyz[axis];
      point[axis] = scalar_at(data, i * header.stride + field.offset, field.type);
    }
    raw.points.push_back(point);
  }
}

/// Compressed data is field after field: all x, then all y, …
void read_compressed(const Source& source, const Header& header, std::string_view data,
                     RawGeometry& raw) {
  if (data.size() < 8) fail_truncated(source, *header.points, 0);
  const auto packed = load_le<std::uint32_t>(data, 0), unpacked = load_le<std::uint32_t>(data, 4);
  data.remove_prefix(8);
  if (packed > data.size()) {
    fail(source, "truncated: {} bytes of compressed points promised, the file holds {}",
         grouped(packed), grouped(data.size()));
  }
  if (unpacked != *header.points * header.stride || unpacked / kLzfMostExpansion > packed) {
    fail(source, "damaged: {} compressed bytes for {} of {} bytes, {} bytes promised",
         grouped(packed), counted(*header.points, "point"), header.stride, grouped(unpacked));
  }
  std::string fields(unpacked, '\0');
  if (!lzf_decompress(data.substr(0, packed), fields)) {
    fail(source, "damaged: the compressed points do not expand to {} bytes", grouped(unpacked));
  }
  raw.points.resize(*header.points);
  for (int axis = 0; axis < 3; ++axis) {
    const Field& field = header.xyz[axis];
    const std::uint64_t first = field.offset * *header.points;
    for (std::uint64_t i = 0; i < *header.points; ++i) {
      raw.points[i][axis] = scalar_at(fields, first + i * field.type.size, field.type);
    }
  }
}

}  // namespace

RawGeometry decode_pcd(const Source& source) {
  Lines lines(source.bytes);
  const Header header = read_header(source, lines);
  RawGeometry raw;
  if (header.data == "ascii") {
    read_ascii(source, header, lines, raw);
  } else if (header.data == "binary") {
    read_binary(source, header, source.bytes.substr(lines.offset()), raw);
  } else {
    read_compressed(source, header, source.bytes.substr(lines.offset()), raw);
  }
  return raw;
}

}  // namespace arcbid::readers
