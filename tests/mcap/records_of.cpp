// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/mcap/records_of.hpp"

#include <gtest/gtest.h>
#include <zstd.h>

#include <boost/crc.hpp>
#include <fstream>
#include <sstream>

namespace arcbid::mcap_test {
namespace {

constexpr std::string_view magic("\x89\x4d\x43\x41\x50\x30\x0d\x0a");

}  // namespace

std::uint64_t Cursor::number(int size) {
  const std::string_view digits = take(static_cast<std::uint64_t>(size));
  std::uint64_t value = 0;
  for (int i = size - 1; i >= 0; --i)
    value = value << 8 | static_cast<unsigned char>(digits.at(static_cast<std::size_t>(i)));
  return value;
}

std::string_view Cursor::take(std::uint64_t size) {
  if (size > bytes_.size()) throw std::out_of_range("a record is shorter than its fields");
  const std::string_view taken = bytes_.substr(0, size);
  bytes_.remove_prefix(size);
  return taken;
}

std::map<std::string, std::string> Cursor::strings() {
  Cursor inner(take(number(4)));
  std::map<std::string, std::string> read;
  while (!inner.at_end()) {
    const std::string key = inner.string();
    read[key] = inner.string();
  }
  return read;
}

std::map<std::uint64_t, std::uint64_t> Cursor::offsets() {
  Cursor inner(take(number(4)));
  std::map<std::uint64_t, std::uint64_t> read;
  while (!inner.at_end()) {
    const std::uint64_t key = inner.number(2);
    read[key] = inner.number(8);
  }
  return read;
}

std::vector<std::pair<std::uint64_t, std::uint64_t>> Cursor::pairs() {
  Cursor inner(take(number(4)));
  std::vector<std::pair<std::uint64_t, std::uint64_t>> read;
  while (!inner.at_end()) {
    const std::uint64_t first = inner.number(8);
    read.emplace_back(first, inner.number(8));
  }
  return read;
}

std::string Chunk::records() const {
  if (compression.empty()) return packed;
  EXPECT_EQ(compression, "zstd");
  std::string unpacked(uncompressed_size, '\0');
  const std::size_t size =
      ZSTD_decompress(unpacked.data(), unpacked.size(), packed.data(), packed.size());
  EXPECT_EQ(size, uncompressed_size);
  return unpacked;
}

Chunk chunk_of(const Record& record) {
  Cursor at = record.fields();
  Chunk chunk;
  chunk.start_time = at.number(8);
  chunk.end_time = at.number(8);
  chunk.uncompressed_size = at.number(8);
  chunk.crc = at.number(4);
  chunk.compression = at.string();
  chunk.packed = std::string(at.take(at.number(8)));
  EXPECT_TRUE(at.at_end());
  return chunk;
}

Message message_of(const Record& record) {
  EXPECT_EQ(record.opcode, 0x05);
  Cursor at = record.fields();
  Message message;
  message.channel = at.number(2);
  message.sequence = at.number(4);
  message.log_time = at.number(8);
  message.publish_time = at.number(8);
  message.data = record.content.substr(22);
  return message;
}

std::vector<Record> records_in(std::string_view bytes, std::uint64_t from) {
  std::vector<Record> records;
  while (from + 9 <= bytes.size()) {
    Cursor at(bytes.substr(from));
    const int opcode = static_cast<int>(at.number(1));
    const std::uint64_t length = at.number(8);
    if (from + 9 + length > bytes.size()) break;
    records.push_back({opcode, from, from + 9 + length, std::string(at.take(length))});
    from = records.back().end;
  }
  return records;
}

std::string contents(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream out;
  out << in.rdbuf();
  return out.str();
}

std::vector<Record> records_of(const std::filesystem::path& file, bool closed) {
  const std::string all = contents(file);
  EXPECT_EQ(all.substr(0, magic.size()), magic);
  std::string_view bytes = all;
  if (closed) {
    EXPECT_TRUE(all.ends_with(magic));
    bytes.remove_suffix(magic.size());
  }
  std::vector<Record> records = records_in(bytes, magic.size());
  if (closed) {
    EXPECT_EQ(records.back().end, bytes.size()) << "nothing between the last record and the magic";
  }
  return records;
}

std::vector<Record> only(const std::vector<Record>& records, int opcode) {
  std::vector<Record> chosen;
  for (const Record& record : records)
    if (record.opcode == opcode) chosen.push_back(record);
  return chosen;
}

std::vector<Message> messages_of(const std::filesystem::path& file, bool closed) {
  std::vector<Message> messages;
  for (const Record& record : only(records_of(file, closed), 0x06))
    for (const Record& inner : records_in(chunk_of(record).records(), 0))
      messages.push_back(message_of(inner));
  return messages;
}

std::uint32_t crc_of(std::string_view bytes) {
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return crc.checksum();
}

}  // namespace arcbid::mcap_test
