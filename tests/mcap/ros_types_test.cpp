// SPDX-License-Identifier: GPL-3.0-or-later
// Bytes and texts by hand; whole messages are read back by others' readers in read_types_test.cpp.
#include "sim/mcap/ros_types.hpp"

#include <gmock/gmock.h>

#include <map>
#include <set>
#include <sstream>

namespace arcbid {
namespace {

using testing::_;
using testing::Each;
using testing::HasSubstr;
using testing::Pair;

/// Hexadecimal digits, blanks between bytes at will.
std::string bytes(std::string digits) {
  std::erase(digits, ' ');
  std::string read;
  for (std::size_t i = 0; i + 1 < digits.size(); i += 2)
    read.push_back(static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16)));
  return read;
}

const std::string cdr_little_endian = "00 01 00 00";

TEST(RosTypes, StringHasItsLengthAndAZero) {
  EXPECT_EQ(encode(ros::String{"hi"}), bytes(cdr_little_endian + "03000000 68 69 00"));
  EXPECT_EQ(encode(ros::String{}), bytes(cdr_little_endian + "01000000 00"));
}

TEST(RosTypes, Float64IsAlignedBehindTheEncapsulation) {
  EXPECT_EQ(encode(ros::Float64{-2.0}), bytes(cdr_little_endian + "00000000000000C0"));
}

TEST(RosTypes, PaddingIsZero) {
  const ros::PoseStamped pose{{3'000'000'007, "m"}, {{1, 0, 0}, {}}};
  EXPECT_EQ(encode(pose), bytes(cdr_little_endian + "03000000 07000000" +
                                "02000000 6D00 0000 "  // the frame, and padding up to 8
                                "000000000000F03F 0000000000000000 0000000000000000"
                                "0000000000000000 0000000000000000 0000000000000000"
                                "000000000000F03F"));
}

TEST(RosTypes, PointsLieInTheCloudAsTheyAre) {
  const std::string cloud = encode(ros::PointCloud2{{0, "map"}, {{1, 2, -2}, {0.5F, 0, 0}}});
  EXPECT_TRUE(
      cloud.ends_with(bytes("0C000000 18000000 18000000"  // a point, a row, all of it
                            "0000803F 00000040 000000C0 0000003F 00000000 00000000 01")));
}

TEST(RosTypes, ACloudMayBeEmpty) {
  EXPECT_TRUE(encode(ros::PointCloud2{})
                  .ends_with(bytes("0C000000 00000000 00000000"  // a point, a row, all of it
                                   "01")));
}

TEST(RosTypes, EncodesWhatIsLargerThanAtFirstThought) {
  const std::string frame(5000, 'f');
  EXPECT_THAT(encode(ros::PoseStamped{{0, frame}, {}}), HasSubstr(frame));
  EXPECT_EQ(encode(ros::PoseStamped{{0, frame}, {}}).size(), 4 + 8 + 4 + 5001 + 3 + 56u);
}

TEST(RosSchemas, StartWithTheMessageAndNameTheRest) {
  EXPECT_EQ(ros::schema_text(ros::String::type), "string data\n");
  const std::string rule(80, '=');
  EXPECT_EQ(ros::schema_text(ros::PoseStamped::type),
            "std_msgs/Header header\ngeometry_msgs/Pose pose\n" + rule +
                "\nMSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n" + rule +
                "\nMSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n" + rule +
                "\nMSG: geometry_msgs/Pose\ngeometry_msgs/Point position\n"
                "geometry_msgs/Quaternion orientation\n" +
                rule + "\nMSG: geometry_msgs/Point\nfloat64 x\nfloat64 y\nfloat64 z\n" + rule +
                "\nMSG: geometry_msgs/Quaternion\nfloat64 x 0\nfloat64 y 0\nfloat64 z 0\n"
                "float64 w 1\n");
}

TEST(RosSchemas, DefineEveryPartOnce) {
  for (const auto type : {ros::Path::type, ros::PointCloud2::type, ros::MarkerArray::type}) {
    std::istringstream text(ros::schema_text(type));
    std::map<std::string, int> defined;
    std::set<std::string> needed;
    for (std::string word; text >> word;) {
      std::string after_mark;
      if (word == "MSG:" && text >> after_mark)
        ++defined[after_mark];
      else if (word.find('/') != std::string::npos)
        needed.insert(word.substr(0, word.find('[')));
    }
    EXPECT_THAT(defined, Each(Pair(_, 1)));
    EXPECT_THAT(defined, testing::SizeIs(needed.size()));
    for (const std::string& part : needed) EXPECT_TRUE(defined.contains(part)) << part;
  }
}

TEST(RosSchemasDeathTest, AreOfKnownTypes) {
  EXPECT_DEATH(ros::schema_text("nav_msgs/msg/Odometry"), "a ROS type whose definition is known");
}

}  // namespace
}  // namespace arcbid
