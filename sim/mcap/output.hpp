// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string_view>

namespace arcbid::mcap {

/// CRC-32 (ISO-HDLC) of `bytes`, continuing `before`.
std::uint32_t crc32(std::string_view bytes, std::uint32_t before = 0);

/// A file written from front to back that knows how far it is and the CRC of what it wrote. Throws
/// RunError when it cannot be written.
class Output {
 public:
  explicit Output(const std::filesystem::path& path);

  void put(std::string_view bytes);
  /// Hands all to the operating system, so that a crash of ours does not lose it.
  void flush();
  void close();

  /// Bytes written.
  std::uint64_t offset() const { return offset_; }
  /// Of all since the beginning, or since restart_crc().
  std::uint32_t crc() const { return crc_; }
  void restart_crc() { crc_ = 0; }

 private:
  void expect_good() const;

  std::filesystem::path path_;
  std::ofstream file_;
  std::uint64_t offset_ = 0;
  std::uint32_t crc_ = 0;
};

}  // namespace arcbid::mcap
