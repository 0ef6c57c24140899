// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

namespace arcbid::readers {

/// Expands an LZF block (M. Lehmann's LibLZF format, as PCD's binary_compressed uses it) into
/// exactly `out`; false when the block is damaged or holds another number of bytes.
bool lzf_decompress(std::string_view in, std::span<char> out);

/// An LZF block cannot expand more than this: 264 bytes from 3.
inline constexpr std::size_t kLzfMostExpansion = 88;

}  // namespace arcbid::readers
