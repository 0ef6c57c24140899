// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/mcap/chunk.hpp"

#include <zstd.h>

#include <algorithm>

#include "core/base/error.hpp"
#include "sim/mcap/records.hpp"

namespace arcbid::mcap {
namespace {

constexpr std::size_t record_head_size = 1 + 8;
constexpr std::size_t message_fields_size = 2 + 4 + 8 + 8;

}  // namespace

std::string_view name_of(Compression compression) {
  return compression == Compression::zstd ? "zstd" : "";
}

std::size_t Chunk::size_of_message(std::size_t data_size) {
  return record_head_size + message_fields_size + data_size;
}

void Chunk::add(std::uint16_t channel, std::uint32_t sequence, std::uint64_t log_time_ns,
                std::uint64_t publish_time_ns, std::string_view data) {
  start_ns_ = empty() ? log_time_ns : std::min(start_ns_, log_time_ns);
  end_ns_ = empty() ? log_time_ns : std::max(end_ns_, log_time_ns);
  index_[channel].emplace_back(log_time_ns, records_.size());
  records_ += record_head(Opcode::message, message_fields_size + data.size());
  records_ += Fields().u16(channel).u32(sequence).u64(log_time_ns).u64(publish_time_ns).bytes();
  records_ += data;
}

std::string Chunk::compressed(Compression compression) const {
  if (compression == Compression::none) return records_;
  std::string packed(ZSTD_compressBound(records_.size()), '\0');
  const std::size_t size = ZSTD_compress(packed.data(), packed.size(), records_.data(),
                                         records_.size(), ZSTD_CLEVEL_DEFAULT);
  check(!ZSTD_isError(size), "zstd: compressBound() is enough");
  packed.resize(size);
  return packed;
}

}  // namespace arcbid::mcap
