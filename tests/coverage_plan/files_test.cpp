// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "core/coverage/coverage_arcs.hpp"
#include "core/io/structure_reader.hpp"
#include "tests/coverage_plan/held_out.hpp"

namespace arcbid {
namespace {

struct Model {
  const char* file;
  const char* unit = "m";
  double lidar = 0.999, camera = 0.995;
};
void PrintTo(const Model& m, std::ostream* out) {
  *out << m.file;
}

class CoveredFiles : public testing::TestWithParam<Model> {};

TEST_P(CoveredFiles, HoldTheirShareOnFreshSamples) {
  const auto file = std::filesystem::path(ARCBID_SHARED_DATA) / "geometry" / GetParam().file;
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not here";
  const Structure structure = read_structure(file, {.unit = GetParam().unit}).structure;
  for (const bool camera : {false, true}) {
    CoverageSettings settings;
    if (camera) settings.sensor = camera_preset();
    const ArcPlan plan = coverage_arcs(structure, settings);
    const HeldOut held = held_out(structure, plan.arcs, settings);
    EXPECT_GE(held.share(), camera ? GetParam().camera : GetParam().lidar)
        << (camera ? "camera" : "lidar");
    EXPECT_GE(held.least_clearance_m, settings.safety_m);
  }
}

INSTANTIATE_TEST_SUITE_P(All, CoveredFiles,
                         testing::Values(Model{"bridges/truss_span_48m.ply"},
                                         Model{"bridges/duluth_aerial_lift_bridge.obj"},
                                         Model{"bridges/gazebo_truss_bridge.ply", "m", 0.995, 0.99},
                                         Model{"bridges/girder_bridge_cloud.pcd"},
                                         Model{"aircraft/atr72.obj"}));

}  // namespace
}  // namespace arcbid
