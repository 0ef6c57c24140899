// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/readers/ply_header.hpp"

#include <algorithm>
#include <limits>

#include "core/io/readers/text.hpp"

namespace arcbid::readers {
namespace {

using Row = std::vector<std::string_view>;

Scalar scalar_type(const Source& source, std::size_t line, std::string_view name) {
  static constexpr struct {
    std::string_view old_name, new_name;
    Scalar type;
  } kTypes[] = {{"char", "int8", {'I', 1}},     {"uchar", "uint8", {'U', 1}},
                {"short", "int16", {'I', 2}},   {"ushort", "uint16", {'U', 2}},
                {"int", "int32", {'I', 4}},     {"uint", "uint32", {'U', 4}},
                {"float", "float32", {'F', 4}}, {"double", "float64", {'F', 8}}};
  for (const auto& entry : kTypes) {
    if (name == entry.old_name || name == entry.new_name) return entry.type;
  }
  fail_at(
      source, line,
      "{} is no PLY type: legal are char, uchar, short, ushort, int, uint, float, double, int8 to "
      "uint32, float32, float64",
      in_quotes(name));
}

PlyEncoding encoding(const Source& source, std::size_t line, const Row& row) {
  if (row.size() >= 2) {
    if (row[1] == "ascii") return PlyEncoding::ascii;
    if (row[1] == "binary_little_endian") return PlyEncoding::little_endian;
    if (row[1] == "binary_big_endian") return PlyEncoding::big_endian;
  }
  fail_at(source, line, "format {}: legal are ascii, binary_little_endian, binary_big_endian",
          in_quotes(row.size() >= 2 ? row[1] : ""));
}

PlyElement element(const Source& source, std::size_t line, const Row& row) {
  const auto count = row.size() == 3 ? to_integer(row[2]) : std::nullopt;
  if (!count || *count < 0 || *count > std::numeric_limits<std::uint32_t>::max()) {
    fail_at(source, line, "legal is: element NAME COUNT, COUNT from 0 to 4,294,967,295");
  }
  return {std::string(row[1]), static_cast<std::uint64_t>(*count), {}};
}

PlyProperty property(const Source& source, std::size_t line, const Row& row) {
  if (row.size() == 3)
    return {std::string(row[2]), scalar_type(source, line, row[1]), std::nullopt};
  if (row.size() != 5 || row[1] != "list") {
    fail_at(source, line, "legal are: property TYPE NAME, property list TYPE TYPE NAME");
  }
  const Scalar count_type = scalar_type(source, line, row[2]);
  if (count_type.kind == 'F')
    fail_at(source, line, "a list's length cannot be {}", in_quotes(row[2]));
  return {std::string(row[4]), scalar_type(source, line, row[3]), count_type};
}

}  // namespace

PlyHeader read_ply_header(const Source& source) {
  PlyHeader header;
  bool has_format = false;
  Lines lines(source.bytes);
  for (auto line = lines.next(); line; line = lines.next()) {
    const Row row = words(*line);
    if (row.empty() || row[0] == "ply" || row[0] == "comment" || row[0] == "obj_info") continue;
    const std::size_t number = lines.number();
    if (row[0] == "format") {
      header.encoding = encoding(source, number, row);
      has_format = true;
    } else if (row[0] == "element") {
      header.elements.push_back(element(source, number, row));
    } else if (row[0] == "property") {
      if (header.elements.empty()) fail_at(source, number, "a property before any element");
      header.elements.back().properties.push_back(property(source, number, row));
    } else if (row[0] == "end_header") {
      if (!has_format) fail_at(source, number, "the PLY header has no format line");
      header.body_offset = lines.offset();
      header.lines = number;
      return header;
    } else {
      fail_at(source, number, "{} is no header line of a PLY file", in_quotes(row[0]));
    }
  }
  fail(source, "truncated: the PLY header has no end_header line");
}

}  // namespace arcbid::readers
