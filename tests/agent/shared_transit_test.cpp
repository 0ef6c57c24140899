// SPDX-License-Identifier: GPL-3.0-or-later
#include "agent/shared_transit.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <iterator>

#include "core/airspace/obstacle_transit.hpp"
#include "core/io/mission/mission_plan.hpp"

namespace arcbid {
namespace {

const Mission& mission() {
  static const Mission made = [] {
    Config config;
    config.coverage.fill = config.coverage.trim = false;
    config.structure.parametric.length_m = 20;
    config.auction.split_m = 20;
    return plan_mission(config, 7).mission;
  }();
  return made;
}

std::vector<double> table_of(const Mission& m, const std::filesystem::path& run) {
  const auto transit = shared_transit(m, run);
  return dynamic_cast<const ObstacleTransit&>(*transit).table();
}

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

class SharedTransit : public ::testing::Test {
 protected:
  ~SharedTransit() override { std::filesystem::remove_all(run); }
  const std::filesystem::path run =
      std::filesystem::temp_directory_path() /
      fmt::format("arcbid-transit-{}-{}", getpid(),
                  ::testing::UnitTest::GetInstance()->current_test_info()->name());
  void SetUp() override { std::filesystem::create_directories(run); }
};

TEST_F(SharedTransit, IsReadByWhoComesLater) {
  const std::vector<double> first = table_of(mission(), run);
  ASSERT_GT(first.size(), 100u);
  const std::string left = bytes_of(run / "transit.bin");
  EXPECT_EQ(left.size(), 8 * (first.size() + 1));
  EXPECT_EQ(table_of(mission(), run), first);
  EXPECT_EQ(bytes_of(run / "transit.bin"), left);
}

TEST_F(SharedTransit, IsWorkedOutAgainWhereTheFileIsDamagedOrAnothersMission) {
  const std::vector<double> first = table_of(mission(), run);
  const std::string left = bytes_of(run / "transit.bin");
  std::string damaged = left;
  damaged[damaged.size() / 2] ^= 1;
  std::string cut = left;
  cut.resize(left.size() - 9);
  for (const std::string& bad : {damaged, cut, std::string("abc"), std::string()}) {
    std::ofstream(run / "transit.bin", std::ios::binary) << bad;
    EXPECT_EQ(table_of(mission(), run), first);
    EXPECT_EQ(bytes_of(run / "transit.bin"), left);
  }
  Mission other = mission();
  other.fleet[0].home_m.x() += 1;
  EXPECT_NE(table_of(other, run), first);
}

/// Nobody can write there: then the agent works it out for itself.
TEST_F(SharedTransit, NeedsNoDirectory) {
  std::ofstream(run / "file") << "no directory";
  EXPECT_EQ(table_of(mission(), run / "file" / "run"), table_of(mission(), run));
}

}  // namespace
}  // namespace arcbid
