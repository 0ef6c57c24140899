// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <ctime>
#include <filesystem>
#include <ostream>

#include "core/io/structure_reader.hpp"
#include "core/structure/bridge_arcs.hpp"
#include "tests/structure/arc_laws.hpp"

namespace arcbid {
namespace {

struct Model {
  const char* file;
  const char* unit = "m";
  double standoff_m = 4;
};
void PrintTo(const Model& m, std::ostream* out) {
  *out << m.file;
}

class Files : public testing::TestWithParam<Model> {};

TEST_P(Files, BecomeArcsThatKeepTheLaws) {
  const auto file = std::filesystem::path(ARCBID_SHARED_DATA) / "geometry" / GetParam().file;
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not here";
  const Structure structure = read_structure(file, {.unit = GetParam().unit}).structure;
  CoverageSettings settings;
  settings.standoff_m = GetParam().standoff_m;
  for (const double spacing_m : {3.0, 5.0}) {
    settings.spacing_m = spacing_m;
    const std::clock_t start = std::clock();
    const ArcPlan plan = bridge_arcs(structure, settings);
    const double took_s = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    expect_arc_laws(plan, structure, settings);
    EXPECT_GT(plan.within_reach, 0.8);  // convex outlines stay far from concave parts
    double length = 0;
    for (const Arc& arc : plan.arcs) length += length_m(arc.waypoints);
    fmt::print("{}: D {} m: {} arcs, {:.0f} m, reach {:.4f}, {:.2f} CPU s\n", GetParam().file,
               spacing_m, plan.arcs.size(), length, plan.within_reach, took_s);
    for (const std::string& warning : plan.warnings) fmt::print("  {}\n", warning);
  }
}

INSTANTIATE_TEST_SUITE_P(All, Files,
                         testing::Values(Model{"bridges/truss_span_48m.ply"},
                                         Model{"bridges/quinte_skyway.stl"},
                                         Model{"bridges/duluth_aerial_lift_bridge.obj"},
                                         Model{"bridges/gazebo_truss_bridge.ply"},
                                         Model{"bridges/gazebo_cloverleaf_inches.obj", "in"},
                                         Model{"bridges/girder_bridge_cloud.pcd"},
                                         Model{"aircraft/a380.ply"}, Model{"aircraft/atr72.obj"},
                                         Model{"aircraft/dr400.stl"},
                                         Model{"structures/fcplanner_pipe_ascii.pcd"},
                                         Model{"structures/fcplanner_tianqin_compressed.pcd"},
                                         Model{"structures/caric_crane_dense.pcd"}));

}  // namespace
}  // namespace arcbid
