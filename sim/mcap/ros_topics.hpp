// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "sim/mcap/ros_types.hpp"
#include "sim/mcap/writer.hpp"

namespace arcbid::ros {

/// What a subscriber that comes late gets: nothing, or the topic's last message.
enum class Durability { volatile_topic, transient_local };

template <class Message>
struct Topic {
  mcap::ChannelId channel;
  std::uint32_t next_sequence = 0;
};

/// Topics of ROS messages in an MCAP file of profile "ros2" (MCAP specification, Registry, ROS2):
/// each type's schema once, the topics' quality of service as a bag recorded under Humble states
/// it, which later distributions read too. The writer must outlive it.
class RosTopics {
 public:
  explicit RosTopics(mcap::McapWriter& writer);

  template <class Message>
  Topic<Message> topic(std::string_view name, Durability durability) {
    return {topic_of(Message::type, {}, name, durability)};
  }

  /// One of a type that is not ROS 2's own, with its definition in ROS 2's message language; its
  /// messages, CDR, go to the writer directly.
  mcap::ChannelId topic_of(std::string_view type, std::string_view definition,
                           std::string_view name, Durability durability);

  template <class Message>
  void write(Topic<Message>& topic, std::uint64_t time_ns, const Message& message) {
    writer_.write(topic.channel, topic.next_sequence++, time_ns, time_ns, encode(message));
  }

 private:
  mcap::McapWriter& writer_;
  std::map<std::string, mcap::SchemaId, std::less<>> schemas_;
};

}  // namespace arcbid::ros
