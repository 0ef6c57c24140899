// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/readers/source.hpp"

namespace arcbid::readers {

/// Lines of a text, counted from 1; a line ends at LF or CR LF.
class Lines {
 public:
  explicit Lines(std::string_view text) : text_(text) {}

  /// The next line, or none at the end of the text.
  std::optional<std::string_view> next();

  /// Number of the line that next() gave last.
  std::size_t number() const { return number_; }

  /// Bytes consumed, line ends included.
  std::size_t offset() const { return offset_; }

 private:
  std::string_view text_;
  std::size_t offset_ = 0;
  std::size_t number_ = 0;
};

/// Cuts the next word off `rest`; empty when there is none. Words stand between blanks, tabs, CRs
/// and the characters of `separators`.
std::string_view next_word(std::string_view& rest, std::string_view separators = "");

std::vector<std::string_view> words(std::string_view line, std::string_view separators = "");

/// A whole word as a number, "nan" and "inf" included; none when it is not one.
std::optional<double> to_number(std::string_view word);
std::optional<std::int64_t> to_integer(std::string_view word);

/// The same, or InputError naming the line.
double require_number(const Source& source, std::size_t line, std::string_view word);

std::string lower_case(std::string_view text);

}  // namespace arcbid::readers
