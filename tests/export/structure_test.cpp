// SPDX-License-Identifier: GPL-3.0-or-later
// The structure of a run as other people's readers find it in the export.
#include <gmock/gmock.h>

#include <cstring>

#include "core/io/run/run_files.hpp"
#include "sim/export/mcap_export.hpp"
#include "tests/auction/fleet.hpp"
#include "tests/end_to_end/launched.hpp"
#include "tests/export/recorded_run.hpp"
#include "tests/mcap/read_back.hpp"

namespace arcbid::testing {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class StructureInMcap : public ::testing::Test {
 protected:
  StructureInMcap() {
    RecordedRun recorded(run, random_mission(4, 2, 4));
    recorded.run_for(300'000'000);
    recorded.end();
  }
  std::vector<std::string> export_it() const { return export_mcap(open_run(run), file); }
  /// Messages of each topic, and the first of each, decoded.
  json read() const {
    const auto [exit_code, said] = mcap_test::read(file);
    EXPECT_EQ(exit_code, 0) << said.at("errors");
    return said;
  }
  static json channel(const json& said, const std::string& topic) {
    for (const json& one : said.at("channels"))
      if (one.at("topic") == topic) return one;
    return nullptr;
  }
  static bool has_readers() { return std::filesystem::exists(ARCBID_MCAP_READER_FILE); }

  const Scratch scratch;
  const std::filesystem::path run = scratch / "run", file = scratch / "run.mcap";
};

/// All of it: the reader shows 20 points' bytes.
std::vector<Vec3> points_of(const json& cloud) {
  const std::vector<std::uint8_t> bytes = cloud.at("data").at("first");
  std::vector<float> numbers(bytes.size() / sizeof(float));
  std::memcpy(numbers.data(), bytes.data(), bytes.size());
  std::vector<Vec3> out;
  for (std::size_t n = 0; n + 2 < numbers.size(); n += 3)
    out.emplace_back(numbers[n], numbers[n + 1], numbers[n + 2]);
  return out;
}

void expect_latched_once(const json& channel) {
  EXPECT_EQ(channel.at("messages"), 1);
  EXPECT_THAT(channel.at("metadata").at("offered_qos_profiles").get<std::string>(),
              HasSubstr("durability: 1"));
}

TEST_F(StructureInMcap, ACloudIsThereWithEveryPoint) {
  if (!has_readers()) GTEST_SKIP() << "the readers of MCAP files are not installed";
  Structure cloud;
  for (int n = 0; n < 18; ++n)
    cloud.points.emplace_back(n % 3 + 0.25, n / 3 - 1.5, 20.125 * (n % 2));
  write_structure_file(run, cloud);
  EXPECT_THAT(export_it(), IsEmpty());
  const json said = read(), seen = said.at("first").at("/structure");
  EXPECT_EQ(seen.at("header").at("frame_id"), "map");
  EXPECT_EQ(seen.at("width"), 18);
  EXPECT_EQ(points_of(seen), cloud.points);
  expect_latched_once(channel(said, "/structure"));
  EXPECT_TRUE(channel(said, "/structure_mesh").is_null());
}

TEST_F(StructureInMcap, AMeshIsThereWithItsVerticesAndTriangles) {
  if (!has_readers()) GTEST_SKIP() << "the readers of MCAP files are not installed";
  const Structure mesh{{{0, 0, 0}, {4, 0, 0.5}, {4, 3, 0}, {0, 3, 9.75}}, {{0, 1, 2}, {3, 2, 0}}};
  write_structure_file(run, mesh);
  EXPECT_THAT(export_it(), IsEmpty());
  const json said = read();
  EXPECT_EQ(points_of(said.at("first").at("/structure")), mesh.points);
  const json markers = said.at("first").at("/structure_mesh").at("markers");
  ASSERT_EQ(markers.size(), 1u);
  EXPECT_EQ(markers[0].at("header").at("frame_id"), "map");
  EXPECT_EQ(markers[0].at("type"), 11);  // TRIANGLE_LIST
  EXPECT_EQ(markers[0].at("scale"), json({{"x", 1}, {"y", 1}, {"z", 1}}));
  std::vector<Vec3> corners, expected;
  for (const json& p : markers[0].at("points")) corners.emplace_back(p["x"], p["y"], p["z"]);
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t corner : triangle) expected.push_back(mesh.points[corner]);
  EXPECT_EQ(corners, expected);
  expect_latched_once(channel(said, "/structure_mesh"));
}

TEST_F(StructureInMcap, ARunWithoutOneIsExportedAndSaysSo) {
  EXPECT_THAT(export_it(), ElementsAre(HasSubstr("structure.ply: is not there")));
  if (!has_readers()) GTEST_SKIP() << "the readers of MCAP files are not installed";
  const json said = read();
  EXPECT_TRUE(channel(said, "/structure").is_null());
  EXPECT_FALSE(channel(said, "/arcs").is_null());
}

TEST_F(StructureInMcap, OneThatCannotBeReadIsLeftOut) {
  write_structure_file(run, {{{0, 0, 0}, {4, 0, 1}, {4, 3, 0}}, {}});
  std::filesystem::resize_file(run / "structure.ply",
                               std::filesystem::file_size(run / "structure.ply") - 5);
  EXPECT_THAT(export_it(), ElementsAre(HasSubstr("structure.ply: ")));
  EXPECT_TRUE(std::filesystem::exists(file));
}

}  // namespace
}  // namespace arcbid::testing
