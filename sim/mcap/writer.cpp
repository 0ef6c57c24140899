// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/mcap/writer.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/base/error.hpp"

namespace arcbid::mcap {
namespace {

constexpr std::uint16_t last_id = std::numeric_limits<std::uint16_t>::max();

}  // namespace

McapWriter::McapWriter(const std::filesystem::path& path, WriterOptions options)
    : options_(std::move(options)), out_(path) {
  out_.put(magic);
  out_.put(record(Opcode::header, Fields().string(options_.profile).string(options_.library)));
}

void McapWriter::put_twice(Opcode opcode, const Fields& fields) {
  check(!closed_, "MCAP: written before close()");
  const std::string bytes = record(opcode, fields);
  out_.put(bytes);
  summary_[opcode] += bytes;
}

// Schemas and channels stand outside the chunks, so that they are in the file before any message
// that needs them, and each once.
SchemaId McapWriter::schema(std::string_view name, std::string_view encoding,
                            std::string_view text) {
  check(schemas_ < last_id, "MCAP: fewer than 65536 schemas");
  ++schemas_;  // 0 means none
  put_twice(Opcode::schema, Fields().u16(schemas_).string(name).string(encoding).string(text));
  return SchemaId{schemas_};
}

ChannelId McapWriter::channel(std::string_view topic, SchemaId schema,
                              std::string_view message_encoding, const Map& metadata) {
  const auto schema_id = static_cast<std::uint16_t>(schema);
  check(schema_id <= schemas_, "MCAP: a channel's schema is known");
  check(channels_ < last_id, "MCAP: fewer than 65536 channels");
  ++channels_;
  put_twice(
      Opcode::channel,
      Fields().u16(channels_).u16(schema_id).string(topic).string(message_encoding).map(metadata));
  return ChannelId{channels_};
}

void McapWriter::write(ChannelId channel, std::uint32_t sequence, std::uint64_t log_time_ns,
                       std::uint64_t publish_time_ns, std::string_view data) {
  check(!closed_, "MCAP: written before close()");
  const auto id = static_cast<std::uint16_t>(channel);
  check(id >= 1 && id <= channels_, "MCAP: a message's channel is known");
  const std::size_t size = chunk_.records().size() + Chunk::size_of_message(data.size());
  if (size > options_.chunk_size) finish_chunk();
  chunk_.add(id, sequence, log_time_ns, publish_time_ns, data);
  count_message(id, log_time_ns);
  if (chunk_.records().size() >= options_.chunk_size) finish_chunk();
}

void McapWriter::count_message(std::uint16_t channel, std::uint64_t log_time_ns) {
  start_ns_ = messages_ == 0 ? log_time_ns : std::min(start_ns_, log_time_ns);
  end_ns_ = messages_ == 0 ? log_time_ns : std::max(end_ns_, log_time_ns);
  ++messages_;
  ++messages_of_channel_[channel];
}

/// MCAP specification, Chunk, Message Index and Chunk Index.
void McapWriter::finish_chunk() {
  if (chunk_.empty()) return;
  const std::string_view compression = name_of(options_.compression);
  const std::string packed = chunk_.compressed(options_.compression);
  Fields head;
  head.u64(chunk_.start_ns()).u64(chunk_.end_ns());
  head.u64(chunk_.records().size()).u32(crc32(chunk_.records()));
  head.string(compression).u64(packed.size());

  const std::uint64_t start = out_.offset();
  out_.put(record_head(Opcode::chunk, head.bytes().size() + packed.size()));
  out_.put(head.bytes());
  out_.put(packed);
  const std::uint64_t end = out_.offset();
  std::map<std::uint16_t, std::uint64_t> index_offsets;
  for (const auto& [channel, entries] : chunk_.index()) {
    index_offsets[channel] = out_.offset();
    out_.put(record(Opcode::message_index, Fields().u16(channel).pairs(entries)));
  }
  out_.flush();

  Fields index;
  index.u64(chunk_.start_ns()).u64(chunk_.end_ns()).u64(start).u64(end - start);
  index.map(index_offsets).u64(out_.offset() - end).string(compression);
  index.u64(packed.size()).u64(chunk_.records().size());
  summary_[Opcode::chunk_index] += record(Opcode::chunk_index, index);
  ++chunks_;
  chunk_ = {};
}

/// MCAP specification, Attachment and Attachment Index. The data are not copied.
void McapWriter::attachment(std::string_view name, std::string_view media_type,
                            std::string_view data, std::uint64_t log_time_ns) {
  check(!closed_, "MCAP: written before close()");
  constexpr std::uint64_t create_time_unknown = 0;
  Fields head;
  head.u64(log_time_ns).u64(create_time_unknown).string(name).string(media_type).u64(data.size());
  const std::uint32_t crc = crc32(data, crc32(head.bytes()));

  const std::uint64_t start = out_.offset();
  out_.put(record_head(Opcode::attachment, head.bytes().size() + data.size() + sizeof crc));
  out_.put(head.bytes());
  out_.put(data);
  out_.put(Fields().u32(crc).bytes());

  Fields index;
  index.u64(start).u64(out_.offset() - start).u64(log_time_ns).u64(create_time_unknown);
  index.u64(data.size()).string(name).string(media_type);
  summary_[Opcode::attachment_index] += record(Opcode::attachment_index, index);
  ++attachments_;
}

/// MCAP specification, Metadata and Metadata Index.
void McapWriter::metadata(std::string_view name, const Map& entries) {
  check(!closed_, "MCAP: written before close()");
  const std::uint64_t start = out_.offset();
  out_.put(record(Opcode::metadata, Fields().string(name).map(entries)));
  const Fields index = Fields().u64(start).u64(out_.offset() - start).string(name);
  summary_[Opcode::metadata_index] += record(Opcode::metadata_index, index);
  ++metadata_;
}

void McapWriter::close() {
  check(!closed_, "MCAP: closed once");
  finish_chunk();
  closed_ = true;
  out_.put(record(Opcode::data_end, Fields().u32(out_.crc())));
  write_summary();
  out_.put(magic);
  out_.close();
}

std::string McapWriter::statistics() const {
  Fields fields;
  fields.u64(messages_).u16(schemas_).u32(channels_).u32(attachments_).u32(metadata_).u32(chunks_);
  fields.u64(start_ns_).u64(end_ns_).map(messages_of_channel_);
  return record(Opcode::statistics, fields);
}

/// MCAP specification, Summary Section, Summary Offset Section and Footer. In the order of their
/// opcodes channels come before the statistics, as they must.
void McapWriter::write_summary() {
  summary_[Opcode::statistics] = statistics();
  out_.restart_crc();
  const std::uint64_t start = out_.offset();
  std::string offsets;
  for (const auto& [opcode, records] : summary_) {
    const auto group = static_cast<std::uint8_t>(opcode);
    offsets +=
        record(Opcode::summary_offset, Fields().u8(group).u64(out_.offset()).u64(records.size()));
    out_.put(records);
  }
  const Fields places = Fields().u64(start).u64(out_.offset());
  out_.put(offsets);
  out_.put(record_head(Opcode::footer, places.bytes().size() + sizeof(std::uint32_t)));
  out_.put(places.bytes());
  out_.put(Fields().u32(out_.crc()).bytes());
}

}  // namespace arcbid::mcap
