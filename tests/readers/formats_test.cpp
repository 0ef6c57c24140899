// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/readers/samples.hpp"

namespace arcbid {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

void expect_box_cloud(const StructureInput& input) {
  EXPECT_EQ(input.structure.points, samples::box());
  EXPECT_FALSE(input.structure.is_mesh());
  EXPECT_THAT(input.warnings, IsEmpty());
}

void expect_box_mesh(const StructureInput& input) {
  EXPECT_EQ(input.structure.points, samples::box());
  EXPECT_EQ(input.structure.triangles, samples::box_triangles());
  EXPECT_THAT(input.warnings, IsEmpty());
}

class Encodings : public testing::TestWithParam<std::string> {};

class PcdEncodings : public Encodings {};
TEST_P(PcdEncodings, FieldsInAnyOrderOfAnyType) {
  expect_box_cloud(samples::read("box.pcd", samples::pcd(samples::box(), GetParam())));
}
INSTANTIATE_TEST_SUITE_P(All, PcdEncodings,
                         testing::Values("ascii", "binary", "binary_compressed"));

class PlyEncodings : public Encodings {};
TEST_P(PlyEncodings, MeshWithOtherProperties) {
  expect_box_mesh(samples::read("box.ply", samples::ply(GetParam())));
}
TEST_P(PlyEncodings, CloudWithoutFaces) {
  expect_box_cloud(samples::read("box.ply", samples::ply(GetParam(), false)));
}
INSTANTIATE_TEST_SUITE_P(All, PlyEncodings,
                         testing::Values("ascii", "binary_little_endian", "binary_big_endian"));

class LasFormats : public testing::TestWithParam<std::pair<int, int>> {};
TEST_P(LasFormats, ScaleAndOffset) {
  const auto [minor, format] = GetParam();
  const samples::LasLayout layout{minor, format, 0.25, Vec3(100, -50, 3)};
  expect_box_cloud(samples::read("box.las", samples::las(samples::box(), layout)));
}
INSTANTIATE_TEST_SUITE_P(All, LasFormats,
                         testing::Values(std::pair{0, 0}, std::pair{1, 1}, std::pair{2, 2},
                                         std::pair{2, 3}, std::pair{3, 4}, std::pair{3, 5},
                                         std::pair{4, 6}, std::pair{4, 7}, std::pair{4, 8},
                                         std::pair{4, 9}, std::pair{4, 10}));

TEST(Obj, SlashesNegativeIndicesGroupsAndMaterials) {
  expect_box_mesh(samples::read("box.obj", samples::obj()));
}

TEST(Obj, ContinuedLine) {
  const auto input = samples::read("t.obj", "v 0 0 0\nv 3 0 0\nv 0 3 \\\n0\nf 1 \\\r\n 2 \\\n 3\n");
  EXPECT_EQ(input.structure.triangles.size(), 1u);
}

TEST(Stl, TextWeldsEqualCorners) {
  const auto input = samples::read("box.stl", samples::stl(true));
  EXPECT_EQ(input.structure.points.size(), 8u);
  EXPECT_EQ(input.structure.triangles.size(), 12u);
  EXPECT_THAT(input.warnings, IsEmpty());
}

TEST(Stl, BinaryWhoseHeaderSaysSolid) {
  const auto text = samples::read("box.stl", samples::stl(true));
  const auto binary = samples::read("box.stl", samples::stl(false));
  EXPECT_EQ(binary.structure.points, text.structure.points);
  EXPECT_EQ(binary.structure.triangles, text.structure.triangles);
}

TEST(Xyz, SeparatorsCommentsAndExtraColumns) {
  std::string text = "# scanned today\r\n\r\n";
  for (const Vec3& p : samples::box()) {
    text += fmt::format("{},\t{} ;+{:.3f} 255 name\r\n", p.x(), p.y(), p.z());
  }
  // A comma with a semicolon in the first line of data would be a decimal comma.
  EXPECT_THAT(samples::error("box.xyz", text), HasSubstr("box.xyz:3:"));
  std::erase(text, ';');
  expect_box_cloud(samples::read("box.xyz", text));
}

TEST(Xyz, DecimalCommasAreRefused) {
  EXPECT_THAT(samples::error("c.xyz", "1,5 2,5 3,5\n4,5 5,5 6,5\n"),
              HasSubstr("c.xyz:1: '1,5 2,5 3,5': decimal commas are not read"));
}

TEST(Xyz, HeaderNamesTheColumns) {
  std::string text = "\"id\",\"Z\",\"x\",\"y\"\n";
  for (const Vec3& p : samples::box()) text += fmt::format("7,{},{},{}\n", p.z(), p.x(), p.y());
  expect_box_cloud(samples::read("box.csv", text));
}

TEST(Xyz, PointCountInTheFirstLine) {
  expect_box_cloud(samples::read("box.pts", "8\n" + samples::xyz(samples::box())));
  EXPECT_EQ(samples::error("box.pts", "9\n" + samples::xyz(samples::box())),
            "box.pts: truncated: the first line promises 9 points, the file holds 8");
}

TEST(Pcd, UpperCaseFieldsAndLowerCaseWins) {
  const std::string head = "VERSION 0.7\nFIELDS X x Y Z\nSIZE 4 4 4 4\nTYPE F F F F\n";
  const std::string tail = "WIDTH 2\nHEIGHT 1\nPOINTS 2\nDATA ascii\n9 1 2 3\n9 4 5 6\n";
  const auto input = samples::read("a.pcd", head + tail);  // COUNT may be left out
  EXPECT_EQ(input.structure.points, (std::vector<Vec3>{{1, 2, 3}, {4, 5, 6}}));
}

TEST(Pcd, OrganisedCloud) {
  std::string bytes = samples::pcd(samples::box(), "ascii");
  bytes.replace(bytes.find("WIDTH 8"), 7, "WIDTH 4");
  bytes.replace(bytes.find("HEIGHT 1"), 8, "HEIGHT 2");
  expect_box_cloud(samples::read("box.pcd", bytes));
}

TEST(Las, WithheldAndNoiseAreDropped) {
  std::string bytes = samples::las(samples::box(), {2, 0, 0.01, Vec3::Zero()});
  bytes[227 + 0 * 20 + 15] = static_cast<char>(0x80);
  bytes[227 + 3 * 20 + 15] = 7;
  const auto input = samples::read("box.las", bytes);
  EXPECT_EQ(input.structure.points.size(), 6u);
  EXPECT_THAT(samples::warnings(input), HasSubstr("dropped 2 points"));
}

TEST(AnyFormat, ByteOrderMarkAndWindowsLineEnds) {
  std::string text = samples::obj();
  for (std::size_t at = 0; (at = text.find('\n', at)) != text.npos; at += 2)
    text.insert(at, 1, '\r');
  expect_box_mesh(samples::read("box.obj", "\xef\xbb\xbf" + text));
}

}  // namespace
}  // namespace arcbid
