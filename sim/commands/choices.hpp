// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/error.hpp"

namespace arcbid {

/// Which worlds.
struct Seeds {
  std::uint64_t first = 1, last = 1;
};

/// "7" or "1..1000". Throws InputError.
Seeds seeds_of(const std::string& text);

/// What a command line calls by name. Throws InputError.
template <class E, std::size_t n>
E by_name(const std::array<std::string_view, n>& names, const std::string& name) {
  for (std::size_t i = 0; i < n; ++i)
    if (names[i] == name) return static_cast<E>(i);
  throw InputError(fmt::format("{} is not one of {}", name, fmt::join(names, ", ")));
}

}  // namespace arcbid
