// SPDX-License-Identifier: GPL-3.0-or-later
// Format: Wavefront "Advanced Visualizer" appendix B1, object files.
#include "core/io/readers/decoders.hpp"
#include "core/io/readers/polygons.hpp"
#include "core/io/readers/text.hpp"

namespace arcbid::readers {
namespace {

/// A line, joined with those that follow a '\' at its end.
std::optional<std::string_view> next_statement(Lines& lines, std::string& joined) {
  auto line = lines.next();
  if (!line || !line->ends_with('\\')) return line;
  joined.clear();
  while (line && line->ends_with('\\')) {
    joined.append(line->substr(0, line->size() - 1)).push_back(' ');
    line = lines.next();
  }
  joined.append(line.value_or(""));
  return joined;
}

Vec3 vertex(const Source& source, std::size_t line, std::string_view rest) {
  Vec3 point;
  for (int axis = 0; axis < 3; ++axis) {
    point[axis] = require_number(source, line, next_word(rest));
  }
  return point;
}

/// "7", "7/1", "7//2", "7/1/2": the first number, from 1, or from -1 for the latest vertex so far.
std::int64_t corner(const Source& source, std::size_t line, std::string_view word,
                    std::size_t vertices) {
  const auto number = to_integer(word.substr(0, word.find('/')));
  if (!number || *number == 0) {
    fail_at(source, line, "face corner {}: legal are whole numbers from 1, or from -1 down",
            in_quotes(word));
  }
  if (*number > 0) return *number - 1;
  if (*number < -static_cast<std::int64_t>(vertices)) {
    fail_at(source, line, "face corner {}: only {} vertices stand before this line",
            in_quotes(word), grouped(vertices));
  }
  return *number + static_cast<std::int64_t>(vertices);
}

}  // namespace

RawGeometry decode_obj(const Source& source) {
  RawGeometry raw;
  Polygons polygons;
  Lines lines(source.bytes);
  std::string joined;
  std::size_t curved = 0;
  for (auto line = next_statement(lines, joined); line; line = next_statement(lines, joined)) {
    std::string_view rest = *line;
    const std::string_view key = next_word(rest);
    if (key == "v") {
      raw.points.push_back(vertex(source, lines.number(), rest));
    } else if (key == "f") {
      for (auto word = next_word(rest); !word.empty(); word = next_word(rest)) {
        polygons.corners.push_back(corner(source, lines.number(), word, raw.points.size()));
      }
      polygons.ends.push_back(polygons.corners.size());
      polygons.lines.push_back(lines.number());
    } else if (key == "surf") {
      ++curved;
    }
  }
  if (raw.points.empty()) fail(source, "an OBJ file without a vertex (no line 'v x y z')");
  add_triangles(source, polygons, raw);
  if (curved > 0) {
    raw.warnings.push_back("skipped " + counted(curved, "free-form surface") +
                           ": save the model as polygons to keep them");
  }
  return raw;
}

}  // namespace arcbid::readers
