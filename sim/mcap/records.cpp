// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/mcap/records.hpp"

#include <limits>

#include "core/base/error.hpp"

namespace arcbid::mcap {

Fields& Fields::little_endian(std::uint64_t value, int size) {
  for (int i = 0; i < size; ++i) bytes_.push_back(static_cast<char>(value >> (8 * i)));
  return *this;
}

Fields& Fields::string(std::string_view text) {
  check(text.size() <= std::numeric_limits<std::uint32_t>::max(), "MCAP: a string below 4 GiB");
  u32(static_cast<std::uint32_t>(text.size()));
  bytes_ += text;
  return *this;
}

// Maps and arrays stand behind their length in bytes, like strings.
Fields& Fields::map(const Map& entries) {
  Fields inner;
  for (const auto& [key, value] : entries) inner.string(key).string(value);
  return string(inner.bytes());
}

Fields& Fields::map(const std::map<std::uint16_t, std::uint64_t>& entries) {
  Fields inner;
  for (const auto& [key, value] : entries) inner.u16(key).u64(value);
  return string(inner.bytes());
}

Fields& Fields::pairs(const std::vector<std::pair<std::uint64_t, std::uint64_t>>& entries) {
  Fields inner;
  for (const auto& [first, second] : entries) inner.u64(first).u64(second);
  return string(inner.bytes());
}

std::string record_head(Opcode opcode, std::uint64_t length) {
  return Fields().u8(static_cast<std::uint8_t>(opcode)).u64(length).bytes();
}

std::string record(Opcode opcode, const Fields& fields) {
  return record_head(opcode, fields.bytes().size()) + fields.bytes();
}

}  // namespace arcbid::mcap
