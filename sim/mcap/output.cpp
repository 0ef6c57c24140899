// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/mcap/output.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <cerrno>
#include <cstring>

#include "core/base/error.hpp"

namespace arcbid::mcap {

std::uint32_t crc32(std::string_view bytes, std::uint32_t before) {
  return static_cast<std::uint32_t>(
      crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

Output::Output(const std::filesystem::path& path)
    : path_(path), file_(path, std::ios::binary | std::ios::trunc) {
  expect_good();
}

void Output::put(std::string_view bytes) {
  file_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  expect_good();
  offset_ += bytes.size();
  crc_ = crc32(bytes, crc_);
}

void Output::flush() {
  file_.flush();
  expect_good();
}

void Output::close() {
  file_.close();
  expect_good();
}

void Output::expect_good() const {
  if (!file_)
    throw RunError(fmt::format("{}: cannot be written: {}", path_.string(), std::strerror(errno)));
}

}  // namespace arcbid::mcap
