// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "sim/mcap/chunk.hpp"
#include "sim/mcap/output.hpp"
#include "sim/mcap/records.hpp"

namespace arcbid::mcap {

enum class SchemaId : std::uint16_t {};
enum class ChannelId : std::uint16_t {};

struct WriterOptions {
  /// MCAP specification, Registry, Profiles. "ros2" asks for messages in "cdr", schemas in
  /// "ros2msg" and each channel's "offered_qos_profiles"; see RosTopics.
  std::string profile = "ros2";
  /// Who wrote the file.
  std::string library = "arcbid";
  /// Bytes of message records in a chunk. A message that is larger has a chunk to itself.
  std::size_t chunk_size = 1 << 20;
  Compression compression = Compression::zstd;
};

/// Writes one MCAP file from front to back (MCAP specification, File Structure): schemas, channels,
/// attachments and metadata as they come, messages in chunks, each chunk with its index; close()
/// adds the summary. Holds one chunk and the summary's records in memory. Every CRC of the format
/// is there. The same calls give the same bytes, with one version of zstd.
///
/// Without close() the file ends behind the last chunk that was full: what a reader that goes from
/// front to back, or a recovery tool, can read after a crash.
///
/// Throws RunError when the file cannot be written. Times are nanoseconds since any epoch, the same
/// one throughout the file; messages need not come in their order.
class McapWriter {
 public:
  explicit McapWriter(const std::filesystem::path& path, WriterOptions options = {});

  SchemaId schema(std::string_view name, std::string_view encoding, std::string_view text);
  ChannelId channel(std::string_view topic, SchemaId schema, std::string_view message_encoding,
                    const Map& metadata = {});
  void write(ChannelId channel, std::uint32_t sequence, std::uint64_t log_time_ns,
             std::uint64_t publish_time_ns, std::string_view data);
  void attachment(std::string_view name, std::string_view media_type, std::string_view data,
                  std::uint64_t log_time_ns = 0);
  void metadata(std::string_view name, const Map& entries);
  /// Completes the file; nothing can be written after it.
  void close();

 private:
  void finish_chunk();
  void count_message(std::uint16_t channel, std::uint64_t log_time_ns);
  std::string statistics() const;
  void write_summary();
  /// Into the data section, and to be repeated in the summary.
  void put_twice(Opcode opcode, const Fields& fields);

  WriterOptions options_;
  Output out_;
  bool closed_ = false;
  Chunk chunk_;
  /// The summary's records, a group each opcode.
  std::map<Opcode, std::string> summary_;
  std::map<std::uint16_t, std::uint64_t> messages_of_channel_;
  std::uint64_t messages_ = 0, start_ns_ = 0, end_ns_ = 0;
  std::uint16_t schemas_ = 0, channels_ = 0;
  std::uint32_t attachments_ = 0, metadata_ = 0, chunks_ = 0;
};

}  // namespace arcbid::mcap
