// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace arcbid::mcap {

using Map = std::map<std::string, std::string>;

/// MCAP specification, Records.
enum class Opcode : std::uint8_t {
  header = 0x01,
  footer = 0x02,
  schema = 0x03,
  channel = 0x04,
  message = 0x05,
  chunk = 0x06,
  message_index = 0x07,
  chunk_index = 0x08,
  attachment = 0x09,
  attachment_index = 0x0A,
  statistics = 0x0B,
  metadata = 0x0C,
  metadata_index = 0x0D,
  summary_offset = 0x0E,
  data_end = 0x0F,
};

/// The first and the last bytes of a file. MCAP specification, Magic.
inline constexpr std::string_view magic{"\x89MCAP0\r\n", 8};

/// A record's fields one after the other, as MCAP specification, Serialization, lays them out.
class Fields {
 public:
  Fields& u8(std::uint8_t value) { return little_endian(value, 1); }
  Fields& u16(std::uint16_t value) { return little_endian(value, 2); }
  Fields& u32(std::uint32_t value) { return little_endian(value, 4); }
  Fields& u64(std::uint64_t value) { return little_endian(value, 8); }
  /// With its length in front.
  Fields& string(std::string_view text);
  Fields& map(const Map& entries);
  Fields& map(const std::map<std::uint16_t, std::uint64_t>& entries);
  Fields& pairs(const std::vector<std::pair<std::uint64_t, std::uint64_t>>& entries);

  const std::string& bytes() const { return bytes_; }

 private:
  Fields& little_endian(std::uint64_t value, int size);

  std::string bytes_;
};

/// Opcode and length, which stand before every record's content.
std::string record_head(Opcode opcode, std::uint64_t length);

std::string record(Opcode opcode, const Fields& fields);

}  // namespace arcbid::mcap
