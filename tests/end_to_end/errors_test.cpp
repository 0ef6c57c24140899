// SPDX-License-Identifier: GPL-3.0-or-later
// Bad input, as a user meets it: one clear line, exit code 2, nothing left running.
#include <gtest/gtest.h>

#include "tests/end_to_end/launched.hpp"

namespace arcbid::testing {
namespace {

TEST(Errors, OfAConfigAreToldAllAtOnce) {
  const Scratch scratch;
  const auto config = scratch.file("bad.yaml", "fleet: {agents: -3}\ncoverage: {stand_off_m: 4}\n");
  ::testing::internal::CaptureStderr();
  Launched run({"run", config.string()});
  EXPECT_EQ(run.wait_for_end(10), 2);
}

TEST(Errors, OfTheCommandLineAreExitCodeTwo) {
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {}, {"fly"}, {"run"}, {"run", "no-such.yaml"}, {"run", demo_config(), "--agents", "0"}})
    EXPECT_EQ(Launched(words).wait_for_end(10), 2);
}

TEST(Errors, HelpAndTheConfigReferenceAreExitCodeZero) {
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"--help"}, {"run", "--help"}, {"--version"}, {"config-reference"},
           {"run", demo_config(), "--print-config"}}) {
    Launched run(words);
    EXPECT_EQ(run.wait_for_end(10), 0);
    EXPECT_FALSE(run.output().empty());
  }
}

class BadStructure : public ::testing::TestWithParam<const char*> {};

TEST_P(BadStructure, IsRefusedByTheRunWithExitCodeTwo) {
  const std::string file = shared_data(GetParam());
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not here";
  const Scratch scratch;
  Launched run({"run", demo_config(), "--structure", file, "--out", (scratch / "run").string()});
  EXPECT_EQ(run.wait_for_end(30), 2) << run.output();
  EXPECT_TRUE(all_gone(processes_of(scratch / "run"), 0));
}

INSTANTIATE_TEST_SUITE_P(Of, BadStructure,
                         ::testing::Values("geometry/formats/epsg_4326.las",
                                           "geometry/formats/simple.laz",
                                           "geometry/formats/A_B.e57"));

TEST(Errors, ADirectoryThatHoldsARunIsNotOverwritten) {
  const Scratch scratch;
  const std::string out = (scratch / "run").string();
  ASSERT_EQ(Launched({"run", demo_config(), "--agents", "1", "--out", out}).wait_for_end(60), 0);
  EXPECT_EQ(Launched({"run", demo_config(), "--agents", "1", "--out", out}).wait_for_end(60), 2);
}

}  // namespace
}  // namespace arcbid::testing
