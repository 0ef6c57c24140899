// SPDX-License-Identifier: GPL-3.0-or-later
// Whole files, read with @mcap/core by read_mcap.mjs.
#include <gmock/gmock.h>

#include <fstream>
#include <map>

#include "tests/mcap/read_back.hpp"

namespace arcbid {
namespace {

using mcap_test::read;
using mcap_test::ReadBack;
using nlohmann::json;
using ros::Durability;
using testing::HasSubstr;

class ReadFiles : public ReadBack {};

TEST_P(ReadFiles, ManyChunksOutOfOrder) {
  {
    mcap::McapWriter writer(file_, options());
    ros::RosTopics topics(writer);
    auto words = topics.topic<ros::String>("/words", Durability::transient_local);
    auto more = topics.topic<ros::String>("/more", Durability::volatile_topic);
    topics.topic<ros::Float64>("/silent", Durability::volatile_topic);
    for (std::uint64_t i = 0; i < 300; ++i) {
      topics.write(i % 3 == 0 ? more : words, (i * 7919) % 301, ros::String{std::string(i, 'w')});
      if (i == 100) writer.attachment("arcs.csv", "text/csv", "1,2\n");
    }
    writer.close();
  }
  const auto [exit_code, said] = read(file_);
  EXPECT_EQ(exit_code, 0) << said;
  EXPECT_EQ(said.at("profile"), "ros2");
  EXPECT_EQ(said.at("library"), "arcbid test");
  EXPECT_EQ(said.at("attachments"),
            json::array({{{"name", "arcs.csv"}, {"mediaType", "text/csv"}, {"size", 4}}}));
  EXPECT_EQ(said.at("metadata"), json({{"rosbag2", {{"ROS_DISTRO", "humble"}}}}));
  std::map<std::string, int> messages;
  for (const json& channel : said.at("channels")) {
    messages[channel.at("topic")] = channel.at("messages");
    EXPECT_EQ(channel.at("encoding"), "cdr");
    const std::string qos = channel.at("metadata").at("offered_qos_profiles");
    EXPECT_THAT(qos,
                HasSubstr(channel.at("topic") == "/words" ? "durability: 1" : "durability: 2"));
  }
  EXPECT_EQ(messages,
            (std::map<std::string, int>{{"/more", 100}, {"/silent", 0}, {"/words", 200}}));
}

TEST_P(ReadFiles, NothingAtAll) {
  mcap::McapWriter(file_, options()).close();
  const auto [exit_code, said] = read(file_);
  EXPECT_EQ(exit_code, 0) << said;
  EXPECT_EQ(said.at("channels"), json::array());
}

// That the reader finds faults is what makes the tests above tests.
TEST_P(ReadFiles, FindsBitsThatChanged) {
  read_back(ros::String{std::string(300, 's')});
  std::ifstream in(file_, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(in)), {});
  constexpr std::size_t changes = 7;
  for (std::size_t i = 0; i < changes; ++i) {
    const std::size_t at = i * bytes.size() / changes;
    std::string changed = bytes;
    changed[at] ^= 0x10;
    std::ofstream(file_, std::ios::binary) << changed;
    const auto [exit_code, said] = read(file_);
    EXPECT_EQ(exit_code, 1) << "byte " << at;
    EXPECT_EQ(said.at("errors").size(), 1u);
  }
  std::ofstream(file_, std::ios::binary) << bytes.substr(0, bytes.size() / 2);
  EXPECT_EQ(read(file_).exit_code, 1) << "cut in half";
}

INSTANTIATE_TEST_SUITE_P(Compressions, ReadFiles,
                         testing::Values(mcap::Compression::none, mcap::Compression::zstd),
                         [](const auto& of) { return of.index == 0 ? "none" : "zstd"; });

}  // namespace
}  // namespace arcbid
