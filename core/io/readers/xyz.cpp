// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>

#include "core/io/readers/decoders.hpp"
#include "core/io/readers/text.hpp"

namespace arcbid::readers {
namespace {

constexpr std::string_view kSeparators = ",;";

/// Which words of a line are x, y and z.
using Columns = std::array<std::size_t, 3>;

/// "//X Y Z", "id;x;y;z", "\"x\",\"y\",\"z\"": the columns so named, if all three are.
std::optional<Columns> named_columns(std::string_view line) {
  Columns columns{};
  std::array<bool, 3> found{};
  const auto names = words(line, ",;\"/#");
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string name = lower_case(names[i]);
    const auto axis = std::string_view("xyz").find(name);
    if (name.size() != 1 || axis == std::string_view::npos || found[axis]) continue;
    columns[axis] = i;
    found[axis] = true;
  }
  if (!(found[0] && found[1] && found[2])) return std::nullopt;
  return columns;
}

Vec3 point(const Source& source, std::size_t line, std::string_view text, const Columns& columns) {
  const std::size_t last = *std::max_element(columns.begin(), columns.end());
  Vec3 out;
  for (std::size_t column = 0; column <= last; ++column) {
    const std::string_view word = next_word(text, kSeparators);
    if (word.empty()) {
      fail_at(source, line, "the line has {}: x, y and z are expected", counted(column, "word"));
    }
    for (int axis = 0; axis < 3; ++axis) {
      if (columns[static_cast<std::size_t>(axis)] == column) {
        out[axis] = require_number(source, line, word);
      }
    }
  }
  return out;
}

/// "1,5 2,5 3,5": a comma inside a word, and blanks or semicolons between the words.
bool has_decimal_commas(std::string_view text) {
  if (text.find(';') != text.npos && text.find(',') != text.npos) return true;
  const auto blank = [](char c) { return c == ' ' || c == '\t'; };
  bool tight = false, apart = false;
  for (std::size_t i = 1; i + 1 < text.size(); ++i) {
    tight = tight || (text[i] == ',' && !blank(text[i + 1]));
    apart = apart ||
            (blank(text[i]) && !blank(text[i + 1]) && text[i - 1] != ',' && !blank(text[i - 1]));
  }
  return tight && apart;
}

/// The first line of data fixes the layout of all others.
void check_first(const Source& source, std::size_t line, std::string_view text) {
  if (has_decimal_commas(text)) {
    fail_at(source, line, "{}: decimal commas are not read: write 1.5, not 1,5", in_quotes(text));
  }
}

}  // namespace

RawGeometry decode_xyz(const Source& source) {
  RawGeometry raw;
  Columns columns{0, 1, 2};
  std::optional<std::int64_t> promised;  // a lone number before the data (PTS)
  Lines lines(source.bytes);
  for (auto line = lines.next(); line; line = lines.next()) {
    std::string_view rest = *line;
    const std::string_view first = next_word(rest, kSeparators);
    if (first.empty()) continue;
    if (raw.points.empty()) {
      const bool lone = next_word(rest, kSeparators).empty();
      if (lone && to_integer(first)) {
        promised = to_integer(first);
        continue;
      }
      if (!to_number(first)) {  // a header or a comment
        columns = named_columns(*line).value_or(columns);
        continue;
      }
      check_first(source, lines.number(), *line);
    } else if (first.starts_with('#') || first.starts_with("//")) {
      continue;
    }
    raw.points.push_back(point(source, lines.number(), *line, columns));
  }
  if (promised && *promised > static_cast<std::int64_t>(raw.points.size())) {
    fail(source, "truncated: the first line promises {}, the file holds {}",
         counted(static_cast<std::uint64_t>(*promised), "point"), grouped(raw.points.size()));
  }
  return raw;
}

}  // namespace arcbid::readers
