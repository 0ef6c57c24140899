// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace arcbid::mcap {

enum class Compression { none, zstd };

/// As the format names it.
std::string_view name_of(Compression compression);

/// Message records that are written and compressed together. MCAP specification, Chunk and Message
/// Index.
class Chunk {
 public:
  /// Log time in nanoseconds, and where in the records the message starts.
  using Entries = std::vector<std::pair<std::uint64_t, std::uint64_t>>;

  /// The bytes that a message of `data_size` bytes takes here.
  static std::size_t size_of_message(std::size_t data_size);

  void add(std::uint16_t channel, std::uint32_t sequence, std::uint64_t log_time_ns,
           std::uint64_t publish_time_ns, std::string_view data);

  bool empty() const { return records_.empty(); }
  const std::string& records() const { return records_; }
  std::string compressed(Compression compression) const;
  /// The earliest and the latest log time.
  std::uint64_t start_ns() const { return start_ns_; }
  std::uint64_t end_ns() const { return end_ns_; }
  const std::map<std::uint16_t, Entries>& index() const { return index_; }

 private:
  std::string records_;
  std::uint64_t start_ns_ = 0, end_ns_ = 0;
  std::map<std::uint16_t, Entries> index_;
};

}  // namespace arcbid::mcap
