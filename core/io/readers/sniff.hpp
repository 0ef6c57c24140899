// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/io/readers/source.hpp"

namespace arcbid::readers {

enum class Format : std::uint8_t { pcd, ply, obj, stl, las, xyz };
std::string_view name(Format format);

inline constexpr std::size_t kStlHeaderBytes = 84, kStlFacetBytes = 50;

/// The format, by the content first and the name's ending second. When they disagree, one line is
/// added to `warnings`. Throws InputError for everything that is not read, with the command that
/// converts it where one is known.
Format sniff(const Source& source, std::vector<std::string>& warnings);

/// "solid …" with facets in it, and not a binary STL whose header happens to say "solid".
bool is_text_stl(std::string_view bytes);

[[noreturn]] void refuse_laz(const Source& source);

}  // namespace arcbid::readers
