// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/readers/text.hpp"

#include <charconv>

namespace arcbid::readers {
namespace {

template <class Number>
std::optional<Number> parse(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  Number value{};
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return value;
}

bool separates(char c, std::string_view separators) {
  return c == ' ' || c == '\t' || c == '\r' || separators.find(c) != std::string_view::npos;
}

}  // namespace

std::optional<std::string_view> Lines::next() {
  if (offset_ >= text_.size()) return std::nullopt;
  const std::size_t end = text_.find('\n', offset_);
  std::string_view line = text_.substr(offset_, end == text_.npos ? text_.npos : end - offset_);
  offset_ = end == text_.npos ? text_.size() : end + 1;
  ++number_;
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

std::string_view next_word(std::string_view& rest, std::string_view separators) {
  std::size_t begin = 0;
  while (begin < rest.size() && separates(rest[begin], separators)) ++begin;
  std::size_t end = begin;
  while (end < rest.size() && !separates(rest[end], separators)) ++end;
  const std::string_view word = rest.substr(begin, end - begin);
  rest.remove_prefix(end);
  return word;
}

std::vector<std::string_view> words(std::string_view line, std::string_view separators) {
  std::vector<std::string_view> out;
  for (auto word = next_word(line, separators); !word.empty(); word = next_word(line, separators)) {
    out.push_back(word);
  }
  return out;
}

std::optional<double> to_number(std::string_view word) {
  return parse<double>(word);
}
std::optional<std::int64_t> to_integer(std::string_view word) {
  return parse<std::int64_t>(word);
}

double require_number(const Source& source, std::size_t line, std::string_view word) {
  if (word.empty()) fail_at(source, line, "the line ends where a number is expected");
  const auto value = to_number(word);
  if (!value) fail_at(source, line, "{} is not a number", in_quotes(word));
  return *value;
}

std::string lower_case(std::string_view text) {
  std::string out(text);
  for (char& c : out) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return out;
}

}  // namespace arcbid::readers
