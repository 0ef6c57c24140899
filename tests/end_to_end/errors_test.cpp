// SPDX-License-Identifier: GPL-3.0-or-later
// Bad input, as a user meets it: one clear line, exit code 2, nothing left running.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>

#include "tests/end_to_end/launched.hpp"

namespace arcbid::testing {
namespace {

TEST(Errors, OfAConfigAreToldAllAtOnce) {
  const Scratch scratch;
  const auto config = scratch.file("bad.yaml", "fleet: {agents: -3}\ncoverage: {stand_off_m: 4}\n");
  Launched run({"run", config.string()});
  EXPECT_EQ(run.wait_for_end(10), 2);
  EXPECT_NE(run.output().find("bad.yaml:1:17: fleet.agents"), std::string::npos) << run.output();
  EXPECT_NE(run.output().find("bad.yaml:2:12: coverage.stand_off_m"), std::string::npos)
      << run.output();
}

TEST(Errors, OfTheNetworkAreToldOnce) {
  const Scratch scratch;
  const auto config = scratch.file("far.yaml", "network: {interface_address: 203.0.113.7}\n");
  Launched run({"run", config.string(), "--out", (scratch / "run").string()});
  EXPECT_EQ(run.wait_for_end(20), 2) << run.output();
  const auto at = run.output().find("203.0.113.7");
  ASSERT_NE(at, std::string::npos) << run.output();
  EXPECT_EQ(run.output().find("203.0.113.7", at + 1), std::string::npos) << run.output();
}

/// Without files to open, the launcher is refused its first socket.
int run_without_files(const std::filesystem::path& out) {
  const std::string command =
      "sh -c 'exec 3>&- 4>&- 5>&- 6>&- >/dev/null 2>&1; ulimit -n 4; exec timeout 20 " +
      std::string(ARCBID_BIN_DIR) + "/arcbid run " + demo_config() + " --out " + out.string() + "'";
  return WEXITSTATUS(std::system(command.c_str()));
}

TEST(Errors, LeaveNoDirectoryOfARunThatNeverWas) {
  const Scratch scratch;
  const auto out = scratch / "run";
  EXPECT_EQ(run_without_files(out), 2);
  EXPECT_FALSE(std::filesystem::exists(out));
  std::filesystem::create_directories(out);
  EXPECT_EQ(run_without_files(out), 2);
  EXPECT_TRUE(std::filesystem::exists(out)) << "it was there before";
}

TEST(Errors, OfTheCommandLineAreExitCodeTwo) {
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {}, {"fly"}, {"run"}, {"run", "no-such.yaml"}, {"run", demo_config(), "--agents", "0"}})
    EXPECT_EQ(Launched(words).wait_for_end(10), 2);
}

TEST(Errors, OfAReplayThatWouldNotHeedAnOptionAreOneLine) {
  const Scratch scratch;
  const std::string run = (scratch / "").string();
  using Words = std::vector<std::string>;
  for (const Words& how : std::vector<Words>{{"--verify"}, {"--dds"}})
    for (const Words& option : std::vector<Words>{{"--from", "1"},
                                                  {"--until", "1"},
                                                  {"--agent", "1"},
                                                  {"--arc", "1"},
                                                  {"--topic", "bid"},
                                                  {"--loop"},
                                                  {"--step", "1"}}) {
      Words words{"replay", run, how[0]};
      words.insert(words.end(), option.begin(), option.end());
      Launched replay(words);
      EXPECT_EQ(replay.wait_for_end(10), 2);
      EXPECT_NE(replay.output().find(option[0]), std::string::npos) << replay.output();
      EXPECT_NE(replay.output().find("excludes"), std::string::npos) << replay.output();
      EXPECT_EQ(std::count(replay.output().begin(), replay.output().end(), '\n'), 1);
    }
  Launched rate({"replay", run, "--verify", "--rate", "2"}),
      domain({"replay", run, "--domain", "2"});
  EXPECT_EQ(rate.wait_for_end(10), 2);
  EXPECT_NE(rate.output().find("excludes"), std::string::npos) << rate.output();
  EXPECT_EQ(domain.wait_for_end(10), 2);
  EXPECT_NE(domain.output().find("requires --dds"), std::string::npos) << domain.output();
}

TEST(Errors, HelpAndTheConfigReferenceAreExitCodeZero) {
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"--help"},
                                             {"run", "--help"},
                                             {"--version"},
                                             {"config-reference"},
                                             {"run", demo_config(), "--print-config"}}) {
    Launched run(words);
    EXPECT_EQ(run.wait_for_end(10), 0);
    EXPECT_FALSE(run.output().empty());
  }
}

struct BadFile {
  const char* file;
  const char* says;
};

class BadStructure : public ::testing::TestWithParam<BadFile> {};

TEST_P(BadStructure, IsRefusedWithOneClearLineAndExitCodeTwo) {
  const std::string file = shared_data(GetParam().file);
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not here";
  const Scratch scratch;
  Launched run({"run", demo_config(), "--structure", file, "--out", (scratch / "run").string()});
  EXPECT_EQ(run.wait_for_end(30), 2) << run.output();
  const std::string name = std::filesystem::path(file).filename().string();
  EXPECT_NE(run.output().find(name + ": "), std::string::npos) << run.output();
  EXPECT_NE(run.output().find(GetParam().says), std::string::npos) << run.output();
}

INSTANTIATE_TEST_SUITE_P(Of, BadStructure,
                         ::testing::Values(BadFile{"geometry/formats/epsg_4326.las", "degrees"},
                                           BadFile{"geometry/formats/simple.laz", "laszip"},
                                           BadFile{"geometry/formats/autzen_trim.laz", "laszip"},
                                           BadFile{"geometry/formats/A_B.e57", "E57"}),
                         [](const auto& at) {
                           std::string name =
                               std::filesystem::path(at.param.file).filename().string();
                           std::replace_if(
                               name.begin(), name.end(), [](char c) { return !std::isalnum(c); },
                               '_');
                           return name;
                         });

TEST(Errors, ADirectoryThatHoldsARunIsNotOverwritten) {
  const Scratch scratch;
  const std::string out = (scratch / "run").string();
  ASSERT_EQ(Launched({"run", demo_config(), "--agents", "1", "--out", out}).wait_for_end(60), 0);
  EXPECT_EQ(Launched({"run", demo_config(), "--agents", "1", "--out", out}).wait_for_end(60), 2);
}

}  // namespace
}  // namespace arcbid::testing
