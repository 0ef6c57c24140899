// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/arcs/arc.hpp"
#include "core/base/error.hpp"

namespace arcbid::readers {

/// A file in memory, and its name as messages print it.
struct Source {
  std::string name;
  std::string_view bytes;
};

/// What a decoder yields: the file's own numbers, in its own unit and axes, nothing dropped except
/// what the format itself marks as not there.
struct RawGeometry {
  std::vector<Vec3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  bool repeats_vertices = false;  ///< a soup (STL): equal vertices are the format's way
  std::optional<std::string_view>
      declared_unit;        ///< what the file says of itself, as ReadOptions.unit
  bool in_degrees = false;  ///< the file says that x and y are longitude, latitude
  std::vector<std::string> warnings;
};

/// The file's bytes. Throws InputError for a missing, empty, unreadable or non-regular file.
std::string load(const std::filesystem::path& file);

/// The path in one printable line.
std::string display_name(const std::filesystem::path& file);

/// Text from a file, for a message: in quotes, printable, at most 40 characters.
std::string in_quotes(std::string_view text);

/// 30000 as "30,000".
std::string grouped(std::uint64_t number);

/// "1 point", "2,000 points".
std::string counted(std::uint64_t number, std::string_view singular);

template <class... Args>
[[noreturn]] void fail(const Source& source, fmt::format_string<Args...> format, Args&&... args) {
  throw InputError(source.name + ": " + fmt::format(format, std::forward<Args>(args)...));
}

template <class... Args>
[[noreturn]] void fail_at(const Source& source, std::size_t line,
                          fmt::format_string<Args...> format, Args&&... args) {
  throw InputError(fmt::format("{}:{}: {}", source.name, line,
                               fmt::format(format, std::forward<Args>(args)...)));
}

}  // namespace arcbid::readers
