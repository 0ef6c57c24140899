// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace arcbid::readers {

static_assert(std::endian::native == std::endian::little, "big-endian machines are not supported");

/// A value at a byte offset; the caller has checked that it lies inside.
template <class T>
T load_le(std::string_view bytes, std::size_t offset) {
  T value;
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

template <class T>
T load_be(std::string_view bytes, std::size_t offset) {
  char reversed[sizeof(T)];
  std::reverse_copy(bytes.data() + offset, bytes.data() + offset + sizeof(T), reversed);
  return load_le<T>({reversed, sizeof reversed}, 0);
}

/// The machine types of PCD and PLY: F 4 or 8 bytes, I and U 1, 2, 4 or 8 bytes.
struct Scalar {
  char kind = 'F';
  std::uint32_t size = 4;
  bool legal() const {
    return kind == 'F' ? size == 4 || size == 8
                       : (kind == 'I' || kind == 'U') && size <= 8 && std::has_single_bit(size);
  }
};

/// Any scalar as a double. Throws nothing; `type` is legal.
template <bool big_endian = false>
double scalar_at(std::string_view bytes, std::size_t offset, Scalar type) {
  const auto as = [&]<class T>(T) -> double {
    return static_cast<double>(big_endian ? load_be<T>(bytes, offset) : load_le<T>(bytes, offset));
  };
  if (type.kind == 'F') return type.size == 4 ? as(float{}) : as(double{});
  const bool is_signed = type.kind == 'I';
  switch (type.size) {
    case 1:
      return is_signed ? as(std::int8_t{}) : as(std::uint8_t{});
    case 2:
      return is_signed ? as(std::int16_t{}) : as(std::uint16_t{});
    case 4:
      return is_signed ? as(std::int32_t{}) : as(std::uint32_t{});
    default:
      return is_signed ? as(std::int64_t{}) : as(std::uint64_t{});
  }
}

}  // namespace arcbid::readers
