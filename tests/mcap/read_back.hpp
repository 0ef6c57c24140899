// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "sim/mcap/ros_topics.hpp"

namespace arcbid::mcap_test {

/// How read_mcap.mjs ended, and the JSON that it printed.
struct Reading {
  int exit_code;
  nlohmann::json said;
};

inline Reading read(const std::string& file) {
  const std::string command = ARCBID_MCAP_READER " '" + file + "'";
  FILE* reader = popen(command.c_str(), "r");
  std::string said;
  for (int c = std::fgetc(reader); c != EOF; c = std::fgetc(reader))
    said.push_back(static_cast<char>(c));
  const int status = pclose(reader);
  return {WEXITSTATUS(status), nlohmann::json::parse(said)};
}

class ReadBack : public ::testing::TestWithParam<mcap::Compression> {
 protected:
  ReadBack() {
    std::string name = (std::filesystem::temp_directory_path() / "arcbid_mcap_XXXXXX").string();
    folder_ = mkdtemp(name.data());
    file_ = folder_ + "/run.mcap";
  }
  ~ReadBack() override { std::filesystem::remove_all(folder_); }

  mcap::WriterOptions options() const {
    return {.library = "arcbid test", .chunk_size = 4096, .compression = GetParam()};
  }

  /// Writes one message, and gives it back as others read it.
  template <class Message>
  nlohmann::json read_back(const Message& message) {
    mcap::McapWriter writer(file_, options());
    ros::RosTopics topics(writer);
    auto topic = topics.topic<Message>("/topic", ros::Durability::volatile_topic);
    topics.write(topic, 5, message);
    writer.close();
    const Reading reading = read(file_);
    EXPECT_EQ(reading.exit_code, 0);
    EXPECT_EQ(reading.said.at("errors"), nlohmann::json::array());
    EXPECT_EQ(reading.said.at("channels").at(0).at("schema"), std::string(Message::type));
    return reading.said.at("first").at("/topic");
  }

  std::string folder_, file_;
};

}  // namespace arcbid::mcap_test
