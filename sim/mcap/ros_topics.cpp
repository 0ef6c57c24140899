// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/mcap/ros_topics.hpp"

#include <fmt/format.h>

namespace arcbid::ros {
namespace {

/// The YAML of rosbag2 up to Humble, policies as numbers: keep the last message, reliable,
/// automatic liveliness, and no limits of time.
std::string offered_qos(Durability durability) {
  const auto never = [](std::string_view what) {
    return fmt::format("  {}:\n    sec: 9223372036\n    nsec: 854775807\n", what);
  };
  return "- history: 1\n  depth: 1\n  reliability: 1\n" +
         fmt::format("  durability: {}\n", durability == Durability::transient_local ? 1 : 2) +
         never("deadline") + never("lifespan") + "  liveliness: 1\n" +
         never("liveliness_lease_duration") + "  avoid_ros_namespace_conventions: false";
}

}  // namespace

RosTopics::RosTopics(mcap::McapWriter& writer) : writer_(writer) {
  // Later distributions expect policies as words, unless this record looks like Humble's.
  writer_.metadata("rosbag2", {{"ROS_DISTRO", "humble"}});
}

mcap::ChannelId RosTopics::topic_of(std::string_view type, std::string_view definition,
                                    std::string_view name, Durability durability) {
  auto known = schemas_.find(type);
  if (known == schemas_.end()) {
    const std::string own = definition.empty() ? schema_text(type) : std::string(definition);
    known = schemas_.emplace(type, writer_.schema(type, "ros2msg", own)).first;
  }
  return writer_.channel(name, known->second, "cdr",
                         {{"offered_qos_profiles", offered_qos(durability)}});
}

}  // namespace arcbid::ros
