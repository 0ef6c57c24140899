// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/mcap/writer.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <numeric>

#include "core/base/error.hpp"
#include "tests/mcap/records_of.hpp"

namespace arcbid {
namespace {

using mcap::Compression;
using mcap_test::Cursor;
using mcap_test::Message;
using mcap_test::Record;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

enum : int {
  header = 0x01,
  footer = 0x02,
  schema = 0x03,
  channel = 0x04,
  chunk = 0x06,
  message_index = 0x07,
  chunk_index = 0x08,
  attachment = 0x09,
  attachment_index = 0x0A,
  statistics = 0x0B,
  metadata = 0x0C,
  metadata_index = 0x0D,
  summary_offset = 0x0E,
  data_end = 0x0F
};

/// Each test writes it anew.
const std::string& file_for_this_test() {
  static const struct File {
    ~File() { std::filesystem::remove(name); }
    std::string name = fmt::format("{}/arcbid_writer_{}.mcap", testing::TempDir(), getpid());
  } file;
  return file.name;
}

std::vector<int> opcodes(const std::vector<Record>& records) {
  std::vector<int> all;
  for (const Record& record : records) all.push_back(record.opcode);
  return all;
}

/// Two channels, an attachment and metadata, and as many messages of `size` bytes as there are
/// times; they go to the channels by turns.
std::string write_sample(const std::string& file, mcap::WriterOptions options,
                         const std::vector<std::uint64_t>& times, std::size_t size) {
  mcap::McapWriter writer(file, std::move(options));
  const mcap::SchemaId words = writer.schema("words", "ros2msg", "string data\n");
  const mcap::ChannelId a = writer.channel("/a", words, "cdr", {{"key", "value"}, {"k", ""}});
  writer.metadata("run", {{"seed", "7"}});
  const mcap::ChannelId b = writer.channel("/b", words, "cdr");
  for (std::uint32_t i = 0; i < times.size(); ++i)
    writer.write(i % 2 == 0 ? a : b, i, times[i], times[i] + 1,
                 std::string(size, static_cast<char>('a' + i % 26)));
  writer.attachment("result.json", "application/json", "{}", 5);
  writer.close();
  return file;
}

std::vector<std::uint64_t> upto(std::uint64_t count) {
  std::vector<std::uint64_t> times(count);
  std::iota(times.begin(), times.end(), 100);
  return times;
}

TEST(McapWriter, WritesItsRecordsInOrder) {
  const std::string file =
      write_sample(file_for_this_test(), {.library = "arcbid test"}, upto(3), 4);
  const std::vector<Record> records = mcap_test::records_of(file);
  EXPECT_THAT(opcodes(records),
              ElementsAre(header, schema, channel, metadata, channel, attachment, chunk,
                          message_index, message_index, data_end,  //
                          schema, channel, channel, chunk_index, attachment_index, statistics,
                          metadata_index,  //
                          summary_offset, summary_offset, summary_offset, summary_offset,
                          summary_offset, summary_offset, footer));
  Cursor head = records[0].fields();
  EXPECT_EQ(head.string(), "ros2");
  EXPECT_EQ(head.string(), "arcbid test");
  EXPECT_EQ(records[1].content, records[10].content);
  EXPECT_EQ(records[2].content, records[11].content);
  EXPECT_EQ(records[4].content, records[12].content);
}

TEST(McapWriter, DescribesChannelsAndSchemas) {
  const std::string file = write_sample(file_for_this_test(), {}, {}, 0);
  const std::vector<Record> records = mcap_test::records_of(file);
  Cursor words = records[1].fields();
  EXPECT_EQ(words.number(2), 1u);
  EXPECT_EQ(words.string(), "words");
  EXPECT_EQ(words.string(), "ros2msg");
  EXPECT_EQ(words.string(), "string data\n");
  EXPECT_TRUE(words.at_end());
  Cursor a = records[2].fields();
  EXPECT_EQ(a.number(2), 1u);
  EXPECT_EQ(a.number(2), 1u) << "the schema";
  EXPECT_EQ(a.string(), "/a");
  EXPECT_EQ(a.string(), "cdr");
  EXPECT_EQ(a.strings(), (std::map<std::string, std::string>{{"k", ""}, {"key", "value"}}));
  EXPECT_TRUE(a.at_end());
  EXPECT_EQ(records[4].fields().number(2), 2u);
}

TEST(McapWriter, IsWholeWithoutMessages) {
  mcap::McapWriter(file_for_this_test()).close();
  const std::vector<Record> records = mcap_test::records_of(file_for_this_test());
  EXPECT_THAT(opcodes(records), ElementsAre(header, data_end, statistics, summary_offset, footer));
  EXPECT_EQ(records[2].content, std::string(8 + 2 + 4 * 4 + 2 * 8 + 4, '\0'));
}

TEST(McapWriter, TellsMessagesBack) {
  const std::string file = write_sample(file_for_this_test(), {}, {30, 10}, 3);
  EXPECT_THAT(mcap_test::messages_of(file),
              ElementsAre(Message{1, 0, 30, 31, "aaa"}, Message{2, 1, 10, 11, "bbb"}));
}

// A message of 69 bytes takes 100 with what stands before them.
TEST(McapWriter, KeepsChunksWithinTheirSize) {
  const std::string file = write_sample(
      file_for_this_test(), {.chunk_size = 399, .compression = Compression::none}, upto(8), 69);
  std::vector<std::uint64_t> sizes;
  for (const Record& record : only(mcap_test::records_of(file), chunk))
    sizes.push_back(mcap_test::chunk_of(record).uncompressed_size);
  EXPECT_THAT(sizes, ElementsAre(300, 300, 200));
}

TEST(McapWriter, FillsChunksToTheirSize) {
  const std::string file = write_sample(file_for_this_test(), {.chunk_size = 400}, upto(8), 69);
  EXPECT_THAT(only(mcap_test::records_of(file), chunk), SizeIs(2));
  EXPECT_THAT(mcap_test::messages_of(file), SizeIs(8));
}

TEST(McapWriter, GivesALargeMessageAChunkToItself) {
  {
    mcap::McapWriter writer(file_for_this_test(), {.chunk_size = 100});
    const mcap::ChannelId a = writer.channel("/a", {}, "cdr");
    writer.write(a, 0, 1, 1, "before");
    writer.write(a, 1, 2, 2, std::string(5000, 'x'));
    writer.write(a, 2, 3, 3, "after");
    writer.close();
  }
  std::vector<std::uint64_t> sizes;
  for (const Record& record : only(mcap_test::records_of(file_for_this_test()), chunk))
    sizes.push_back(mcap_test::chunk_of(record).uncompressed_size);
  EXPECT_THAT(sizes, ElementsAre(31 + 6, 31 + 5000, 31 + 5));
}

TEST(McapWriter, CompressesWithoutChangingWhatIsSaid) {
  const std::string packed = write_sample(file_for_this_test(), {}, upto(9), 500);
  const std::vector<Message> messages = mcap_test::messages_of(packed);
  const auto packed_size = std::filesystem::file_size(packed);
  write_sample(file_for_this_test(), {.compression = Compression::none}, upto(9), 500);
  EXPECT_EQ(mcap_test::messages_of(file_for_this_test()), messages);
  EXPECT_GT(std::filesystem::file_size(packed), packed_size + 3000);
}

TEST(McapWriter, StatesTheTimesOfMessagesInAnyOrder) {
  const std::string file =
      write_sample(file_for_this_test(), {.chunk_size = 200, .compression = Compression::none},
                   {50, 20, 90, 70}, 69);
  const std::vector<Record> records = mcap_test::records_of(file);
  std::vector<std::pair<std::uint64_t, std::uint64_t>> spans;
  for (const Record& record : only(records, chunk)) {
    const mcap_test::Chunk read = mcap_test::chunk_of(record);
    spans.emplace_back(read.start_time, read.end_time);
  }
  EXPECT_THAT(spans, ElementsAre(std::pair(20, 50), std::pair(70, 90)));
  const Record summary = only(records, statistics).at(0);
  Cursor all = summary.fields();
  EXPECT_EQ(all.number(8), 4u) << "messages";
  EXPECT_EQ(all.number(2), 1u) << "schemas";
  EXPECT_EQ(all.number(4), 2u) << "channels";
  EXPECT_EQ(all.number(4), 1u) << "attachments";
  EXPECT_EQ(all.number(4), 1u) << "metadata";
  EXPECT_EQ(all.number(4), 2u) << "chunks";
  EXPECT_EQ(all.number(8), 20u);
  EXPECT_EQ(all.number(8), 90u);
  EXPECT_EQ(all.offsets(), (std::map<std::uint64_t, std::uint64_t>{{1, 2}, {2, 2}}));
  EXPECT_TRUE(all.at_end());
}

// The writer still open, the file is as it would be had the process been killed.
TEST(McapWriter, LeavesCompleteChunksBehindWithoutClose) {
  mcap::McapWriter writer(file_for_this_test(), {.chunk_size = 400});
  const mcap::ChannelId a = writer.channel("/a", {}, "cdr");
  for (std::uint32_t i = 0; i < 8; ++i) writer.write(a, i, i, i, std::string(69, 'x'));
  EXPECT_THAT(mcap_test::messages_of(file_for_this_test(), false), SizeIs(8));
  for (std::uint32_t i = 0; i < 2; ++i) writer.write(a, i, i, i, std::string(69, 'x'));
  EXPECT_THAT(mcap_test::messages_of(file_for_this_test(), false), SizeIs(8));
}

TEST(McapWriter, WritesTheSameBytesAgain) {
  const std::string first =
      mcap_test::contents(write_sample(file_for_this_test(), {.chunk_size = 1000}, upto(50), 99));
  EXPECT_EQ(
      mcap_test::contents(write_sample(file_for_this_test(), {.chunk_size = 1000}, upto(50), 99)),
      first);
}

TEST(McapWriter, SaysWhenAFileCannotBeWritten) {
  const std::string place = testing::TempDir() + "arcbid_no_such_folder/run.mcap";
  try {
    mcap::McapWriter writer(place);
    FAIL() << "no error";
  } catch (const RunError& error) {
    EXPECT_EQ(error.what(), place + ": cannot be written: No such file or directory");
  }
}

TEST(McapWriter, SaysWhenTheDiskIsFull) {
  mcap::McapWriter writer("/dev/full", {.chunk_size = 100});
  const mcap::ChannelId a = writer.channel("/a", {}, "cdr");
  EXPECT_THROW(writer.write(a, 0, 0, 0, std::string(100, 'x')), RunError);
  EXPECT_THROW(mcap::McapWriter("/dev/full").close(), RunError);
}

TEST(McapWriterDeathTest, HoldsItsCallerToTheFormat) {
  mcap::McapWriter writer(file_for_this_test());
  EXPECT_DEATH(writer.write(mcap::ChannelId{1}, 0, 0, 0, ""), "a message's channel is known");
  EXPECT_DEATH(writer.channel("/a", mcap::SchemaId{1}, "cdr"), "a channel's schema is known");
  writer.close();
  EXPECT_DEATH(writer.metadata("late", {}), "before close");
}

}  // namespace
}  // namespace arcbid
