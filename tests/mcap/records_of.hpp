// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace arcbid::mcap_test {

/// Reads an MCAP record's fields by the specification; shares nothing with the writer.
class Cursor {
 public:
  explicit Cursor(std::string_view bytes) : bytes_(bytes) {}

  std::uint64_t number(int size);
  std::string_view take(std::uint64_t size);
  std::string string() { return std::string(take(number(4))); }
  std::map<std::string, std::string> strings();
  std::map<std::uint64_t, std::uint64_t> offsets();
  std::vector<std::pair<std::uint64_t, std::uint64_t>> pairs();
  bool at_end() const { return bytes_.empty(); }

 private:
  std::string_view bytes_;
};

struct Record {
  int opcode;
  std::uint64_t start;  ///< of the opcode
  std::uint64_t end;
  std::string content;

  Cursor fields() const& { return Cursor(content); }
  Cursor fields() const&& = delete;  // it would look into what is gone
};

struct Message {
  std::uint64_t channel, sequence, log_time, publish_time;
  std::string data;

  bool operator==(const Message&) const = default;
};

struct Chunk {
  std::uint64_t start_time, end_time, uncompressed_size, crc;
  std::string compression, packed;

  /// Uncompressed.
  std::string records() const;
};

Chunk chunk_of(const Record& record);
Message message_of(const Record& record);

/// Records one after the other; stops before one that is cut off.
std::vector<Record> records_in(std::string_view bytes, std::uint64_t from);

std::string contents(const std::filesystem::path& file);

/// All records of a file, magics checked. A file that was not closed has no magic at its end.
std::vector<Record> records_of(const std::filesystem::path& file, bool closed = true);

std::vector<Record> only(const std::vector<Record>& records, int opcode);

/// The messages in all chunks, in their order there.
std::vector<Message> messages_of(const std::filesystem::path& file, bool closed = true);

std::uint32_t crc_of(std::string_view bytes);

}  // namespace arcbid::mcap_test
