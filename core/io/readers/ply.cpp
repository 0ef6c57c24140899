// SPDX-License-Identifier: GPL-3.0-or-later
// Format: G. Turk, "The PLY Polygon File Format", 1994.
#include <algorithm>
#include <array>

#include "core/io/readers/decoders.hpp"
#include "core/io/readers/ply_header.hpp"
#include "core/io/readers/polygons.hpp"
#include "core/io/readers/text.hpp"

namespace arcbid::readers {
namespace {

/// The body as a stream of numbers; ended() turns true when the file runs out of them.
template <bool big_endian>
class BinaryValues {
 public:
  BinaryValues(const Source& source, const PlyHeader& header)
      : bytes_(source.bytes.substr(header.body_offset)) {}
  void begin_item() {}
  double next(Scalar type) {
    if (!can_hold(1, type)) {
      ended_ = true;
      return 0;
    }
    const double value = scalar_at<big_endian>(bytes_, 0, type);
    bytes_.remove_prefix(type.size);
    return value;
  }
  bool can_hold(double count, Scalar type) const {
    return count <= static_cast<double>(bytes_.size() / type.size);
  }
  bool ended() const { return ended_; }
  std::optional<std::size_t> line() const { return std::nullopt; }

 private:
  std::string_view bytes_;
  bool ended_ = false;
};

/// The same for ascii: one item a line.
class TextValues {
 public:
  TextValues(const Source& source, const PlyHeader& header)
      : source_(source), lines_(source.bytes.substr(header.body_offset)), before_(header.lines) {}
  void begin_item() {
    do {
      const auto line = lines_.next();
      ended_ = !line;
      rest_ = line.value_or("");
    } while (!ended_ && rest_.find_first_not_of(" \t\r") == std::string_view::npos);
  }
  double next(Scalar) { return ended_ ? 0 : require_number(source_, *line(), next_word(rest_)); }
  bool can_hold(double count, Scalar) const { return count <= static_cast<double>(rest_.size()); }
  bool ended() const { return ended_; }
  std::optional<std::size_t> line() const { return before_ + lines_.number(); }

 private:
  const Source& source_;
  Lines lines_;
  std::size_t before_;
  std::string_view rest_;
  bool ended_ = false;
};

/// What a property means to us.
enum class Role : std::uint8_t { x, y, z, corners, ignored };

std::vector<Role> roles(const Source& source, const PlyElement& element) {
  std::vector<Role> out(element.properties.size(), Role::ignored);
  std::array<bool, 3> found{};
  for (std::size_t i = 0; i < out.size(); ++i) {
    const PlyProperty& property = element.properties[i];
    const std::string name = lower_case(property.name);
    const auto axis = std::string_view("xyz").find(name);
    if (element.name == "face" && property.count_type &&
        (name == "vertex_indices" || name == "vertex_index")) {
      out[i] = Role::corners;
    } else if (element.name == "vertex" && name.size() == 1 && axis != std::string_view::npos &&
               !property.count_type && !found[axis]) {
      out[i] = static_cast<Role>(axis);
      found[axis] = true;
    }
  }
  if (element.name == "vertex" && !(found[0] && found[1] && found[2])) {
    fail(source, "element vertex has no property {}", found[0] ? (found[1] ? "z" : "y") : "x");
  }
  if (element.name == "face" && element.count > 0 &&
      std::find(out.begin(), out.end(), Role::corners) == out.end()) {
    fail(source, "element face has no list property vertex_indices or vertex_index");
  }
  return out;
}

template <class Values>
void read_list(const Source& source, const PlyElement& element, const PlyProperty& property,
               std::uint64_t item, Values& values, std::vector<std::int64_t>* out) {
  const double length = values.next(*property.count_type);
  if (values.ended()) return;
  if (!(length >= 0) || !values.can_hold(length, property.type)) {
    fail(source, "{} {}: list {} of length {} does not fit into the rest of the file",
         in_quotes(element.name), item, in_quotes(property.name), length);
  }
  for (double i = 0; i < length; ++i) {
    const double value = values.next(property.type);
    // Not a number, or far outside every index: the range check names it as -1.
    if (out)
      out->push_back(value >= -1e15 && value <= 1e15 ? static_cast<std::int64_t>(value) : -1);
  }
}

template <class Values>
void read_element(const Source& source, const PlyElement& element, Values& values, RawGeometry& raw,
                  Polygons& polygons) {
  const std::vector<Role> role = roles(source, element);
  if (element.properties.empty()) return;
  if (element.name == "vertex") {
    raw.points.reserve(std::min<std::uint64_t>(element.count, source.bytes.size() / 3));
  }
  for (std::uint64_t item = 0; item < element.count; ++item) {
    values.begin_item();
    Vec3 point = Vec3::Zero();
    for (std::size_t i = 0; i < role.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      if (property.count_type) {
        read_list(source, element, property, item, values,
                  role[i] == Role::corners ? &polygons.corners : nullptr);
      } else {
        const double value = values.next(property.type);
        if (role[i] <= Role::z) point[static_cast<int>(role[i])] = value;
      }
    }
    if (values.ended()) {
      fail(source, "truncated: the header promises {}, the file holds {}",
           counted(element.count, in_quotes(element.name) + " item"), grouped(item));
    }
    if (element.name == "vertex") raw.points.push_back(point);
    if (element.name == "face") {
      polygons.ends.push_back(polygons.corners.size());
      if (const auto line = values.line()) polygons.lines.push_back(*line);
    }
  }
}

template <class Values>
RawGeometry read_body(const Source& source, const PlyHeader& header) {
  RawGeometry raw;
  Polygons polygons;
  Values values(source, header);
  for (const PlyElement& element : header.elements) {
    read_element(source, element, values, raw, polygons);
  }
  add_triangles(source, polygons, raw);
  return raw;
}

}  // namespace

RawGeometry decode_ply(const Source& source) {
  const PlyHeader header = read_ply_header(source);
  const auto has = [&](std::string_view name) {
    return std::count_if(header.elements.begin(), header.elements.end(),
                         [&](const PlyElement& element) { return element.name == name; });
  };
  if (has("vertex") != 1 || has("face") > 1) {
    fail(source, "a PLY structure has one element vertex and at most one element face");
  }
  if (has("tristrips") > 0) {
    fail(source, "element tristrips is not read: save the mesh with plain faces");
  }
  switch (header.encoding) {
    case PlyEncoding::ascii:
      return read_body<TextValues>(source, header);
    case PlyEncoding::little_endian:
      return read_body<BinaryValues<false>>(source, header);
    case PlyEncoding::big_endian:
      return read_body<BinaryValues<true>>(source, header);
  }
  return {};
}

}  // namespace arcbid::readers
