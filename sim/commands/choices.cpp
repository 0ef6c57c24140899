// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/commands/choices.hpp"

#include <charconv>

namespace arcbid {

Seeds seeds_of(const std::string& text) {
  const auto wrong = [&] {
    return InputError(
        fmt::format("--seeds {}: is not a seed or FIRST..LAST, such as 1..1000", text));
  };
  const auto number = [&](std::string_view part) {
    std::uint64_t value = 0;
    const auto [stop, error] = std::from_chars(part.data(), part.data() + part.size(), value);
    if (error != std::errc() || stop != part.data() + part.size()) throw wrong();
    return value;
  };
  const std::size_t dots = text.find("..");
  if (dots == std::string::npos) return {number(text), number(text)};
  const Seeds seeds{number(std::string_view(text).substr(0, dots)),
                    number(std::string_view(text).substr(dots + 2))};
  if (seeds.last < seeds.first) throw wrong();
  return seeds;
}

}  // namespace arcbid
