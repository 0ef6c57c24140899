// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <limits>

#include "tests/readers/samples.hpp"

namespace arcbid {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::vector<Vec3> box_of(double x, double y, double z, const Vec3& at = Vec3::Zero()) {
  auto points = samples::box();
  for (Vec3& p : points) p = at + p.cwiseProduct(Vec3(x / 20, y / 10, z / 5));
  return points;
}

StructureInput read(const std::vector<Vec3>& points, const ReadOptions& options = {}) {
  return samples::read("bridge.xyz", samples::xyz(points), options);
}

std::string error(const std::vector<Vec3>& points, const ReadOptions& options = {}) {
  return samples::error("bridge.xyz", samples::xyz(points), options);
}

TEST(Units, EachUnitInMetres) {
  const std::pair<std::string, double> units[] = {{"m", 1},       {"cm", 0.01},
                                                  {"mm", 0.001},  {"ft", 0.3048},
                                                  {"in", 0.0254}, {"us-ft", 1200.0 / 3937.0}};
  for (const auto& [unit, metres] : units) {
    const auto input = read(box_of(60 / metres, 12 / metres, 9 / metres), {.unit = unit});
    EXPECT_NEAR(input.structure.points[1].x(), 30, 1e-9) << unit;
    EXPECT_NEAR(input.structure.points[7].z(), 9, 1e-9) << unit;
    EXPECT_THAT(input.warnings, IsEmpty()) << unit;
  }
}

TEST(Units, MillimetresReadAsMetres) {
  EXPECT_THAT(error(box_of(30'000, 12'000, 9'000)),
              AllOf(HasSubstr("30,000 m by 12,000 m by 9,000 m tall, read in m"),
                    HasSubstr("--unit mm (30 m)"), HasSubstr("--unit in (762 m)")));
  EXPECT_THAT(samples::warnings(read(box_of(15'000, 9'000, 900))),
              AllOf(HasSubstr("is the unit wrong?"), HasSubstr("--unit mm (15 m)")));
  EXPECT_THAT(error(box_of(60, 12, 9), {.unit = "mm"}), HasSubstr("say --unit m (60 m)"));
  EXPECT_THAT(samples::warnings(read(box_of(1.5, 1, 1))), HasSubstr("is the unit wrong?"));
  EXPECT_THAT(read(box_of(2'900, 20, 90)).warnings, IsEmpty());
}

TEST(Units, GeographicAndFootKeysOfLas) {
  const auto with_key = [](std::uint16_t key, std::uint16_t value) {
    std::string bytes = samples::las(samples::box());
    std::string record(54 + 16, '\0');
    record.replace(2, 15, "LASF_Projection");
    samples::put(record, 18, std::uint16_t{34735});
    samples::put(record, 20, std::uint16_t{16});
    samples::put(record, 62, key);
    samples::put(record, 68, value);
    bytes.insert(227, record);
    samples::put(bytes, 96, static_cast<std::uint32_t>(227 + record.size()));
    samples::put(bytes, 100, std::uint32_t{1});
    return bytes;
  };
  EXPECT_THAT(samples::error("a.las", with_key(1024, 2)), HasSubstr("degrees"));
  EXPECT_THAT(samples::warnings(samples::read("a.las", with_key(3076, 9003))),
              HasSubstr("its unit is us-ft, read in m: say --unit us-ft"));
  EXPECT_THAT(samples::read("a.las", with_key(3076, 9002), {.unit = "ft"}).warnings, IsEmpty());
}

TEST(Degrees, ByTheExtents) {
  EXPECT_THAT(error(box_of(0.02, 0.01, 39, Vec3(-94.67, 31.04, 39))),
              AllOf(HasSubstr("degrees of longitude and latitude"), HasSubstr("EPSG:32615")));
  EXPECT_THAT(error(box_of(0.002, 0.001, 30, Vec3(151.2, -33.85, 0))), HasSubstr("EPSG:32756"));
  // A thin mast at the origin is not a place on Earth.
  EXPECT_THAT(samples::warnings(read(box_of(0.05, 0.05, 39))), HasSubstr("another axis up"));
}

TEST(Axes, UpMapsToZAndKeepsHandedness) {
  const Vec3 x(3, 0, 0), y(0, 5, 0), z(0, 0, 7), zero = Vec3::Zero();
  const auto y_up = read({zero, x, y, z}, {.up = 'y'}).structure.points;
  EXPECT_EQ(y_up, (std::vector<Vec3>{zero, {3, 0, 0}, {0, 0, 5}, {0, -7, 0}}));
  const auto x_up = read({zero, x, y, z}, {.up = 'x'}).structure.points;
  EXPECT_EQ(x_up, (std::vector<Vec3>{zero, {0, 0, 3}, {5, 0, 0}, {0, 7, 0}}));
}

TEST(Axes, TallerThanWideAsksForTheAxis) {
  EXPECT_THAT(samples::warnings(read(box_of(20, 12, 300))),
              HasSubstr("20 m by 12 m by 300 m tall: is another axis up? say --up y"));
  EXPECT_THAT(read(box_of(20, 12, 59)).warnings, IsEmpty());
}

TEST(Frame, FarFromTheOriginIsMoved) {
  const auto input = read(box_of(60, 12, 8, Vec3(637'000, 850'000, 150)));
  EXPECT_EQ(input.structure.points[0], Vec3(-30, -6, 150));
  EXPECT_EQ(input.structure.points[7], Vec3(30, 6, 158));
  EXPECT_THAT(samples::warnings(input), HasSubstr("moved by (-637000.000, -850000.000, 0) m"));
  const auto near = read(box_of(60, 12, 8, Vec3(500, 800, 0)));
  EXPECT_EQ(near.structure.points[0], Vec3(470, 794, 0));
  EXPECT_THAT(near.warnings, IsEmpty());
}

TEST(Dirt, NanAndDuplicatesAreDroppedAndCountedInOrder) {
  auto points = samples::box();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  points.insert(points.begin(), Vec3(nan, 0, 0));
  points.insert(points.begin() + 4, Vec3(0, std::numeric_limits<double>::infinity(), 0));
  points.insert(points.begin() + 5, Vec3(1e300, 0, 0));
  points.push_back(points[2]);
  points.push_back(Vec3(-10, -5, -0.0));  // equals the first corner
  const auto input = read(points);
  EXPECT_EQ(input.structure.points, samples::box());
  EXPECT_THAT(samples::warnings(input), AllOf(HasSubstr("bridge.xyz: dropped 3 points with NaN"),
                                              HasSubstr("dropped 2 duplicate points")));
}

TEST(Dirt, NothingLeft) {
  EXPECT_THAT(error({Vec3(1, 2, 3), Vec3(1, 2, 3)}), HasSubstr("all points lie on one spot"));
  EXPECT_THAT(samples::error("a.xyz", "nan nan nan\ninf 0 0\n"), HasSubstr("none of the 2 points"));
  EXPECT_THAT(samples::error("a.pcd", samples::pcd({}, "ascii")), HasSubstr("holds no point"));
  EXPECT_THAT(samples::error("a.obj", "v 0 0 0\nv 3 0 0\nv 6 0 0\nf 1 2 3\n"),
              HasSubstr("no triangle of 1 has an area"));
}

TEST(Dirt, OutliersOfACloud) {
  boost::random::mt19937_64 random(7);
  const boost::random::uniform_real_distribution<double> unit(0, 1);
  std::vector<Vec3> points;
  for (int i = 0; i < 2000; ++i) {
    points.emplace_back(60 * unit(random), 12 * unit(random), 9 * unit(random));
  }
  const auto clean = points;
  points.insert(points.begin() + 100, Vec3(0, 0, 400));
  points.emplace_back(-50'000, 0, 0);
  const auto input = samples::read("a.pcd", samples::pcd(points, "ascii"));
  EXPECT_EQ(input.structure.points, clean);
  EXPECT_THAT(samples::warnings(input), HasSubstr("dropped 2 outliers"));
  points.back() = Vec3(-30, 0, 0);  // outside, but within reach: a wing wall, not a bird
  EXPECT_THAT(samples::warnings(samples::read("a.pcd", samples::pcd(points, "ascii"))),
              HasSubstr("dropped 1 outlier "));
}

TEST(Dirt, MeshDropsFlatTrianglesLooseVerticesAndNanCorners) {
  std::string text = samples::obj();
  text += "v 500 500 500\nv nan 0 0\nv 0 -5 0\n";
  text += "f 1 2 11\n";  // collinear: the middle of the edge 1-2
  text += "f 1 3 10\nf 1 1 4\n";
  const auto input = samples::read("a.obj", text);
  EXPECT_EQ(input.structure.points, samples::box());
  EXPECT_EQ(input.structure.triangles, samples::box_triangles());
  EXPECT_THAT(
      samples::warnings(input),
      AllOf(HasSubstr("dropped 1 point with NaN"), HasSubstr("1 triangle with a NaN corner"),
            HasSubstr("2 triangles without area"), HasSubstr("2 points that no triangle")));
}

TEST(Dirt, FlatCloud) {
  const auto input = read({Vec3(0, 0, 3), Vec3(9, 0, 3), Vec3(9, 7, 3)});
  EXPECT_THAT(samples::warnings(input), HasSubstr("one horizontal plane"));
}

}  // namespace
}  // namespace arcbid
