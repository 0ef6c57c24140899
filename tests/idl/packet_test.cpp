// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <set>

#include "idl/guid_prefix.hpp"
#include "idl/rtps_packet.hpp"
#include "tests/idl/packets.hpp"

namespace arcbid {
namespace {

using namespace packets;

const GuidPrefix someone = new_guid_prefix(AgentId{7}, "127.0.0.1");

TEST(GuidPrefix, SaysWhichAgent) {
  for (const std::uint32_t id : {1u, 255u, 256u, 65535u})
    EXPECT_EQ(agent_of(new_guid_prefix(AgentId{id}, "127.0.0.1")), AgentId{id});
  EXPECT_EQ(agent_of(new_guid_prefix(std::nullopt, "127.0.0.1")), std::nullopt);
}

TEST(GuidPrefix, IsAnotherOneInEachLife) {
  std::set<GuidPrefix> made;
  for (int life = 0; life < 1000; ++life) made.insert(new_guid_prefix(AgentId{1}, "127.0.0.1"));
  EXPECT_EQ(made.size(), 1000u);
}

TEST(GuidPrefix, BeginsWithVendorAndHost) {
  const GuidPrefix here = new_guid_prefix(AgentId{1}, "192.0.2.1"),
                   also_here = new_guid_prefix(AgentId{2}, "192.0.2.1"),
                   there = new_guid_prefix(AgentId{1}, "192.0.2.2");
  EXPECT_EQ(here[0], 0x01);
  EXPECT_EQ(here[1], 0x0f);
  EXPECT_TRUE(std::equal(here.begin(), here.begin() + 4, also_here.begin()));
  EXPECT_FALSE(std::equal(here.begin(), here.begin() + 4, there.begin()));
}

TEST(GuidPrefix, OfAForeignParticipantNamesNobody) {
  GuidPrefix other_vendor = someone;
  other_vendor[1] = 0x10;
  EXPECT_EQ(agent_of(other_vendor), std::nullopt);
  // As Fast DDS makes them by itself: the last four bytes count its participants.
  EXPECT_EQ(agent_of({1, 0x0f, 9, 9, 9, 9, 9, 9, 3, 0, 0, 0}), std::nullopt);
}

TEST(Packet, SaysWhoSentIt) {
  EXPECT_EQ(sender_of(bid(someone)), someone);
}

TEST(Packet, ThatIsNotRtpsHasNoSender) {
  Bytes packet = bid(someone);
  packet[3] = 'X';
  EXPECT_EQ(sender_of(packet), std::nullopt);
  EXPECT_EQ(sender_of(Bytes{}), std::nullopt);
}

TEST(Packet, ThatEndsInItsHeaderHasNoSender) {
  Bytes packet = header(someone);
  EXPECT_EQ(sender_of(packet), someone);
  packet.pop_back();
  EXPECT_EQ(sender_of(packet), std::nullopt);
  EXPECT_FALSE(is_discovery(packet));
}

TEST(Packet, OfABuiltInWriterIsDiscovery) {
  EXPECT_TRUE(is_discovery(announcement(someone)));
  EXPECT_FALSE(is_discovery(bid(someone)));
  for (const std::uint8_t kind : {0xc2, 0xc3})
    EXPECT_TRUE(is_discovery(header(someone) + data(kind)));
  for (const std::uint8_t kind : {0x02, 0x03, 0x42, 0x82})
    EXPECT_FALSE(is_discovery(header(someone) + data(kind)));
}

TEST(Packet, ThatSpeaksAboutDiscoveryIsDiscoveryToo) {
  for (const std::uint8_t kind : {0x06, 0x07, 0x08, 0x12, 0x13}) {
    EXPECT_TRUE(is_discovery(header(someone) + submessage(kind, entities(built_in_writer))));
    EXPECT_FALSE(is_discovery(header(someone) + submessage(kind, entities(user_writer))));
  }
  const Bytes fragment = Bytes{0, 0, 28, 0} + entities(built_in_writer);
  EXPECT_TRUE(is_discovery(header(someone) + submessage(0x16, fragment)));
}

TEST(Packet, IsDiscoveryByAnyOfItsSubmessages) {
  EXPECT_TRUE(is_discovery(bid(someone) + data(built_in_writer)));
  EXPECT_FALSE(is_discovery(bid(someone) + data(user_writer)));
}

TEST(Packet, MayStateLengthsInBigEndian) {
  Bytes first = info_timestamp();
  first[1] = 0;
  std::swap(first[2], first[3]);
  EXPECT_TRUE(is_discovery(header(someone) + first + data(built_in_writer)));
}

TEST(Packet, MayLeaveTheLastLengthOpen) {
  const Bytes open = submessage(0x07, entities(built_in_writer), 0);
  EXPECT_TRUE(is_discovery(header(someone) + open));
  // With the flag that says so a timestamp is empty, and the next submessage follows.
  EXPECT_TRUE(is_discovery(header(someone) + submessage(0x09, {}) + data(built_in_writer)));
}

TEST(Packet, MayBeCutShortAnywhere) {
  const Bytes whole = announcement(someone);
  std::size_t first_to_show = 0;
  for (std::size_t size = whole.size(); size > 0; --size)
    if (is_discovery({whole.data(), size})) first_to_show = size;
  EXPECT_EQ(first_to_show, header(someone).size() + info_timestamp().size() + 4 + 4 + 8);
  // A length that lies beyond the end.
  EXPECT_FALSE(is_discovery(header(someone) + submessage(0x09, Bytes(8), 999) + data(0xc2)));
}

}  // namespace
}  // namespace arcbid
