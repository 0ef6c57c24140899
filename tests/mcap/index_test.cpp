// SPDX-License-Identifier: GPL-3.0-or-later
// What a reader that jumps needs: offsets that hit, and CRCs.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include "sim/mcap/writer.hpp"
#include "tests/mcap/records_of.hpp"

namespace arcbid {
namespace {

using mcap_test::Cursor;
using mcap_test::Record;
using testing::SizeIs;

/// Three chunks, two channels, two attachments and metadata.
class McapIndex : public testing::TestWithParam<mcap::Compression> {
 protected:
  McapIndex() {
    const std::string file = fmt::format("{}/arcbid_index_{}.mcap", testing::TempDir(), getpid());
    mcap::McapWriter writer(file, {.chunk_size = 400, .compression = GetParam()});
    const mcap::SchemaId schema = writer.schema("words", "ros2msg", "string data\n");
    const mcap::ChannelId a = writer.channel("/a", schema, "cdr");
    const mcap::ChannelId b = writer.channel("/b", schema, "cdr");
    for (std::uint32_t i = 0; i < 9; ++i)
      writer.write(i % 4 == 3 ? b : a, i, 1000 - i, i, std::string(69, 'x'));
    writer.attachment("arcs.csv", "text/csv", "1,2\n", 77);
    writer.attachment("empty", "text/plain", "");
    writer.metadata("run", {{"seed", "7"}});
    writer.close();
    bytes_ = mcap_test::contents(file);
    records_ = mcap_test::records_of(file);
    std::filesystem::remove(file);
  }

  /// The record that starts there.
  const Record& at(std::uint64_t offset) const {
    for (const Record& record : records_)
      if (record.start == offset) return record;
    throw std::out_of_range("no record starts there");
  }

  std::string bytes_;
  std::vector<Record> records_;
};

TEST_P(McapIndex, OfChunksPointsToThemAndToTheirMessages) {
  const auto indexes = only(records_, 0x08);
  ASSERT_THAT(indexes, SizeIs(3));
  for (const Record& index : indexes) {
    Cursor field = index.fields();
    const std::uint64_t start_time = field.number(8), end_time = field.number(8);
    const Record& chunk = at(field.number(8));
    ASSERT_EQ(chunk.opcode, 0x06);
    EXPECT_EQ(field.number(8), chunk.end - chunk.start);
    const mcap_test::Chunk read = mcap_test::chunk_of(chunk);
    EXPECT_EQ(read.start_time, start_time);
    EXPECT_EQ(read.end_time, end_time);
    const std::string messages = read.records();
    std::size_t found = 0, index_bytes = 0;
    for (const auto& [channel, offset] : field.offsets()) {
      const Record& of_channel = at(offset);
      ASSERT_EQ(of_channel.opcode, 0x07);
      index_bytes += of_channel.end - of_channel.start;
      Cursor entries = of_channel.fields();
      EXPECT_EQ(entries.number(2), channel);
      for (const auto& [time, place] : entries.pairs()) {
        const mcap_test::Message message =
            mcap_test::message_of(mcap_test::records_in(messages, place).at(0));
        EXPECT_EQ(message.log_time, time);
        EXPECT_EQ(message.channel, channel);
        ++found;
      }
    }
    EXPECT_EQ(found, messages.size() / 100) << "every message is in the index";
    EXPECT_EQ(field.number(8), index_bytes);
    EXPECT_EQ(field.string(), read.compression);
    EXPECT_EQ(field.number(8), read.packed.size());
    EXPECT_EQ(field.number(8), messages.size());
    EXPECT_TRUE(field.at_end());
  }
}

TEST_P(McapIndex, OfAttachmentsPointsToThem) {
  const auto indexes = only(records_, 0x0A);
  ASSERT_THAT(indexes, SizeIs(2));
  Cursor field = indexes[0].fields();
  const Record& attachment = at(field.number(8));
  ASSERT_EQ(attachment.opcode, 0x09);
  EXPECT_EQ(field.number(8), attachment.end - attachment.start);
  EXPECT_EQ(field.number(8), 77u) << "log time";
  EXPECT_EQ(field.number(8), 0u) << "time of creation: unknown";
  EXPECT_EQ(field.number(8), 4u) << "size";
  EXPECT_EQ(field.string(), "arcs.csv");
  EXPECT_EQ(field.string(), "text/csv");
  EXPECT_TRUE(field.at_end());

  Cursor content = attachment.fields();
  EXPECT_EQ(content.number(8), 77u);
  EXPECT_EQ(content.number(8), 0u);
  EXPECT_EQ(content.string(), "arcs.csv");
  EXPECT_EQ(content.string(), "text/csv");
  EXPECT_EQ(content.take(content.number(8)), "1,2\n");
  const std::string_view before_crc =
      std::string_view(attachment.content).substr(0, attachment.content.size() - 4);
  EXPECT_EQ(content.number(4), mcap_test::crc_of(before_crc));
  EXPECT_TRUE(content.at_end());
}

TEST_P(McapIndex, OfMetadataPointsToThem) {
  const auto indexes = only(records_, 0x0D);
  ASSERT_THAT(indexes, SizeIs(1));
  Cursor field = indexes[0].fields();
  const Record& metadata = at(field.number(8));
  ASSERT_EQ(metadata.opcode, 0x0C);
  EXPECT_EQ(field.number(8), metadata.end - metadata.start);
  EXPECT_EQ(field.string(), "run");
  EXPECT_TRUE(field.at_end());
  Cursor content = metadata.fields();
  EXPECT_EQ(content.string(), "run");
  EXPECT_EQ(content.strings(), (std::map<std::string, std::string>{{"seed", "7"}}));
  EXPECT_TRUE(content.at_end());
}

TEST_P(McapIndex, OffsetsCoverTheSummary) {
  Cursor footer = records_.back().fields();
  const std::uint64_t summary = footer.number(8), offsets = footer.number(8);
  EXPECT_EQ(at(summary).start, only(records_, 0x0F).at(0).end) << "right behind the data";
  EXPECT_EQ(at(offsets).opcode, 0x0E);
  std::uint64_t covered = summary;
  for (const Record& record : only(records_, 0x0E)) {
    Cursor field = record.fields();
    const int group = static_cast<int>(field.number(1));
    ASSERT_EQ(field.number(8), covered);
    const std::uint64_t end = covered + field.number(8);
    for (; covered < end; covered = at(covered).end) EXPECT_EQ(at(covered).opcode, group);
    EXPECT_EQ(covered, end);
  }
  EXPECT_EQ(covered, offsets);
}

TEST_P(McapIndex, EveryCrcHolds) {
  for (const Record& record : only(records_, 0x06)) {
    const mcap_test::Chunk chunk = mcap_test::chunk_of(record);
    EXPECT_EQ(chunk.crc, mcap_test::crc_of(chunk.records()));
  }
  const Record data_end = only(records_, 0x0F).at(0);
  EXPECT_EQ(data_end.fields().number(4),
            mcap_test::crc_of(std::string_view(bytes_).substr(0, data_end.start)));
  const Record& footer = records_.back();
  Cursor field = footer.fields();
  const std::uint64_t summary = field.number(8);
  field.number(8);
  EXPECT_EQ(field.number(4),
            mcap_test::crc_of(std::string_view(bytes_).substr(summary, footer.end - 4 - summary)));
  EXPECT_TRUE(field.at_end());
}

INSTANTIATE_TEST_SUITE_P(Compressions, McapIndex,
                         testing::Values(mcap::Compression::none, mcap::Compression::zstd),
                         [](const auto& of) { return of.index == 0 ? "none" : "zstd"; });

}  // namespace
}  // namespace arcbid
