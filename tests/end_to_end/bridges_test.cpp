// SPDX-License-Identifier: GPL-3.0-or-later
// Bridges that nobody here made, with fleets of several sizes.
#include <gtest/gtest.h>

#include "tests/end_to_end/launched.hpp"

namespace arcbid::testing {
namespace {

struct Case {
  std::string file, unit;
  int agents;
};

class Bridges : public ::testing::TestWithParam<Case> {};

TEST_P(Bridges, AreAllocatedAndChecked) {
  const Case& bridge = GetParam();
  const std::string file = shared_data("geometry/bridges/" + bridge.file);
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not here";
  const Scratch scratch;
  // Quinte at full detail takes minutes on two cores; what is tested here is the fleet.
  const bool is_large = bridge.file.starts_with("quinte");
  const std::string config =
      is_large
          ? std::string(scratch.file(
                "config.yaml",
                "coverage: {spacing_m: 12, fill: false, trim: false}\nauction: {split_m: 60}\n"))
          : demo_config();
  Launched run({"run", config, "--structure", file, "--unit", bridge.unit, "--agents",
                std::to_string(bridge.agents), "--no-certificate", "--out",
                (scratch / "run").string()});
  ASSERT_EQ(run.wait_for_end(150), 0) << run.output();
  expect_checked(read_json(scratch / "run/result.json"), static_cast<std::size_t>(bridge.agents));
}

std::vector<Case> all() {
  std::vector<Case> cases;
  for (const auto& [file, unit] :
       std::vector<std::pair<std::string, std::string>>{{"truss_span_48m.ply", "m"},
                                                        {"quinte_skyway.stl", "m"},
                                                        {"duluth_aerial_lift_bridge.obj", "m"},
                                                        {"gazebo_truss_bridge.ply", "m"},
                                                        {"gazebo_cloverleaf_inches.obj", "in"},
                                                        {"girder_bridge_cloud.pcd", "m"}})
    for (const int agents : {2, 4, 6}) cases.push_back({file, unit, agents});
  cases.push_back({"girder_bridge_cloud.pcd", "m", 16});
  return cases;
}

INSTANTIATE_TEST_SUITE_P(Third, Bridges, ::testing::ValuesIn(all()), [](const auto& at) {
  const Case& c = at.param;
  return c.file.substr(0, c.file.find('.')) + "_" + std::to_string(c.agents);
});

}  // namespace
}  // namespace arcbid::testing
