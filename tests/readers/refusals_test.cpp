// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.hpp"
#include "tests/readers/samples.hpp"

namespace arcbid {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string message(const std::filesystem::path& file, const ReadOptions& options = {}) {
  try {
    read_structure(file, options);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST(Refusals, MissingDirectoryEmpty) {
  EXPECT_EQ(message("/nowhere/bridge.pcd"), "/nowhere/bridge.pcd: no such file");
  EXPECT_THAT(message(testing::TempDir()), HasSubstr("is a directory"));
  EXPECT_EQ(message("/dev/null"), "/dev/null: is not a regular file");
  EXPECT_EQ(samples::error("bridge.pcd", ""), "bridge.pcd: the file is empty");
  EXPECT_EQ(message("bridge\n.pcd"), "bridge?.pcd: no such file");
}

TEST(Refusals, NameTheCommandThatConverts) {
  EXPECT_EQ(samples::error("a b.e57", "ASTM-E57 and more"),
            "a b.e57: is an E57 scan, which is not read: convert it: pdal translate \"a b.e57\" "
            "\"a b.las\"");
  EXPECT_THAT(samples::error("a.pcd.gz", "\x1f\x8b\x08 and more"), HasSubstr("gunzip a.pcd.gz"));
  EXPECT_THAT(samples::error("a.zip", "PK\x03\x04 and more"), HasSubstr("unzip a.zip"));
  EXPECT_THAT(samples::error("a.ifc", "ISO-10303-21;\nHEADER;"),
              HasSubstr("IfcConvert a.ifc a.obj"));
  EXPECT_THAT(samples::error("a.dxf", "  0\r\nSECTION\r\n  2\r\nHEADER\r\n"), HasSubstr("DXF"));
  EXPECT_THAT(samples::error("a.glb", "glTF\x02"), HasSubstr("assimp export a.glb a.obj"));
  EXPECT_THAT(samples::error("a.fbx", "Kaydara FBX Binary  "), HasSubstr("assimp export a.fbx"));
  EXPECT_THAT(samples::error("a.dae", "\n<?xml version=\"1.0\"?>"), HasSubstr("COLLADA"));
}

TEST(Refusals, LazByItsFormatBitsOrItsRecord) {
  std::string bits = samples::las(samples::box());
  bits[104] = static_cast<char>(bits[104] | 0x80);
  EXPECT_THAT(samples::error("a.laz", bits), HasSubstr("laszip -i a.laz -o a.las"));

  std::string record = samples::las(samples::box());
  std::string vlr(54, '\0');
  vlr.replace(2, 14, "laszip encoded");
  record.insert(227, vlr);
  samples::put(record, 96, std::uint32_t{227 + 54});
  samples::put(record, 100, std::uint32_t{1});
  EXPECT_THAT(samples::error("a.las", record), HasSubstr("laszip -i a.las -o a.plain.las"));
}

TEST(Refusals, UnknownContent) {
  EXPECT_EQ(samples::error("a.ply", "hello there, this is prose"),
            "a.ply: is not a PLY file, it starts with 'hello there, thi': legal are PCD, PLY, OBJ, "
            "STL, LAS and text with x y z in each line");
  EXPECT_THAT(samples::error("a.bin", std::string("\x01\x00\xfe noise", 9)),
              HasSubstr("a.bin: the format is not known, it starts with '??? noise'"));
}

TEST(Refusals, ContentWinsOverTheName) {
  const auto input = samples::read("bridge.ply", samples::stl(false));
  EXPECT_EQ(input.structure.triangles.size(), 12u);
  EXPECT_THAT(samples::warnings(input),
              HasSubstr("bridge.ply: the content is STL, not PLY as the name says: read as STL"));
  EXPECT_TRUE(samples::read("bridge", samples::stl(false)).warnings.empty());
}

/// Names come from the file: they may be as long as it, and hold whatever it does.
TEST(Refusals, NamesAreShownShortened) {
  const std::string name(2000, 'n');
  const std::string head = "ply\nformat ascii 1.0\nelement " + name + " 2\n";
  EXPECT_LT(samples::error("a.ply", head + "property int i\nend_header\n1\n").size(), 200u);
  const std::string list = "property list uchar int corners\nend_header\n200 1\n";
  EXPECT_LT(samples::error("a.ply", head + list).size(), 200u);
}

TEST(Refusals, TruncatedSaysExpectedAndFound) {
  const auto cut = [](std::string bytes, std::size_t by) {
    return bytes.substr(0, bytes.size() - by);
  };
  const auto box = samples::box();
  const std::string promise = "truncated: the header promises 8 points, the file holds ";
  EXPECT_EQ(samples::error("a.pcd", cut(samples::pcd(box, "binary"), 18)),
            "a.pcd: " + promise + "6");
  EXPECT_EQ(samples::error("a.pcd", cut(samples::pcd(box, "ascii"), 27)),
            "a.pcd: " + promise + "6");
  EXPECT_THAT(samples::error("a.pcd", cut(samples::pcd(box, "binary_compressed"), 1)),
              HasSubstr("truncated"));
  EXPECT_EQ(samples::error("a.las", cut(samples::las(box), 1)), "a.las: " + promise + "7");
  EXPECT_EQ(samples::error("a.stl", cut(samples::stl(false), 60)),
            "a.stl: truncated: the header promises 12 triangles, the file holds 10");
  EXPECT_THAT(samples::error("a.stl", cut(samples::stl(true), 20)), HasSubstr("truncated"));
  EXPECT_EQ(samples::error("a.ply", cut(samples::ply("binary_big_endian"), 16)),
            "a.ply: truncated: the header promises 12 'face' items, the file holds 10");
  EXPECT_THAT(samples::error("a.ply", samples::ply("ascii").substr(0, 60)),
              HasSubstr("end_header"));
}

TEST(Refusals, BadValuesNameFieldAndLine) {
  const auto broken = [](std::string bytes, std::string_view from, std::string_view to) {
    bytes.replace(bytes.find(from), from.size(), to);
    return bytes;
  };
  const std::string pcd = samples::pcd(samples::box(), "ascii"), ply = samples::ply("ascii");
  EXPECT_THAT(samples::error("a.pcd", broken(pcd, "7 8 9 10", "7 8 9 ten")),
              HasSubstr("a.pcd:13: 'ten' is not a number"));
  EXPECT_THAT(samples::error("a.pcd", broken(pcd, "FIELDS intensity x z", "FIELDS intensity x a")),
              HasSubstr("field z is missing: the fields are' intensity x a y'"));
  EXPECT_THAT(samples::error("a.pcd", broken(pcd, "SIZE 1 4", "SIZE 4")),
              HasSubstr("a.pcd:4: SIZE"));
  EXPECT_THAT(samples::error("a.pcd", broken(pcd, "TYPE U F", "TYPE U Q")), HasSubstr("'Q'"));
  EXPECT_THAT(samples::error("a.pcd", broken(pcd, "WIDTH 8", "WIDTH 7")),
              HasSubstr("POINTS 8 is not WIDTH 7 times HEIGHT 1"));
  EXPECT_THAT(samples::error("a.pcd", broken(pcd, "DATA ascii", "DATA text")),
              HasSubstr("legal are ascii, binary, binary_compressed"));
  EXPECT_THAT(samples::error("a.pcd", broken(pcd, "POINTS 8", "POINTS -8")), HasSubstr("'-8'"));
  EXPECT_THAT(samples::error("a.ply", broken(ply, "property double y", "property double w")),
              HasSubstr("no property y"));
  EXPECT_THAT(samples::error("a.ply", broken(ply, "float x", "flaot x")),
              HasSubstr("a.ply:5: 'flaot' is no PLY type"));
  EXPECT_THAT(samples::error("a.ply", broken(ply, "ascii 1.0", "utf8 1.0")),
              HasSubstr("a.ply:2: format 'utf8'"));
  EXPECT_THAT(samples::error("a.obj", "v 1 2\nv 1 2 3\n"), HasSubstr("a.obj:1: the line ends"));
  EXPECT_THAT(samples::error("a.xyz", "1 2 3\n4 5\n"), HasSubstr("a.xyz:2: the line has 2 words"));
  std::string las = samples::las(samples::box());
  samples::put(las, 139, 0.0);
  EXPECT_THAT(samples::error("a.las", las), HasSubstr("LAS y scale factor 0"));
  las = samples::las(samples::box());
  las[25] = 9;
  EXPECT_THAT(samples::error("a.las", las), HasSubstr("LAS version 1.9: legal are 1.0 to 1.4"));
}

TEST(Refusals, OptionsAreCheckedBeforeTheFile) {
  EXPECT_EQ(message("/nowhere", {.unit = "km"}), "unit 'km': legal are m, cm, mm, ft, us-ft, in");
  EXPECT_EQ(message("/nowhere", {.up = 'w'}), "up 'w': legal are x, y, z");
}

}  // namespace
}  // namespace arcbid
