// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/io/readers/binary.hpp"
#include "core/io/readers/source.hpp"

namespace arcbid::readers {

enum class PlyEncoding : std::uint8_t { ascii, little_endian, big_endian };

struct PlyProperty {
  std::string name;
  Scalar type;
  std::optional<Scalar> count_type;  ///< set: a list, whose length comes first in this type
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::ascii;
  std::vector<PlyElement> elements;
  std::size_t body_offset = 0;  ///< bytes
  std::size_t lines = 0;        ///< lines before the body
};

/// From "ply" to "end_header". Throws InputError naming the line.
PlyHeader read_ply_header(const Source& source);

}  // namespace arcbid::readers
