// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/auction/spread.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace arcbid {
namespace {

TEST(Spread, UniformityIsThatOfThePaper) {
  // mu = 4, deviations -1, 0, 1: E = 3 / (2 + 3).
  EXPECT_DOUBLE_EQ(uniformity(std::vector{3.0, 4.0, 5.0}), 0.6);
  // mu = 10, deviations -10, 10: E = 2 / (200 + 2).
  EXPECT_DOUBLE_EQ(uniformity(std::vector{0.0, 20.0}), 2 / 202.0);
  EXPECT_EQ(uniformity(std::vector{7.0, 7.0, 7.0, 7.0}), 1);
  EXPECT_EQ(uniformity(std::vector<double>{}), 0);
}

TEST(Spread, VariationHasNoUnit) {
  EXPECT_DOUBLE_EQ(variation(std::vector{3.0, 4.0, 5.0}), std::sqrt(2 / 3.0) / 4);
  EXPECT_DOUBLE_EQ(variation(std::vector{3e3, 4e3, 5e3}), std::sqrt(2 / 3.0) / 4);
  EXPECT_EQ(variation(std::vector{7.0, 7.0}), 0);
  EXPECT_EQ(variation(std::vector{0.0, 0.0}), 0);
  EXPECT_EQ(variation(std::vector<double>{}), 0);
}

TEST(Spread, OfARunIsThatOfItsFlightTimes) {
  CheckReport report;
  for (const double time_s : {3.0, 4.0, 5.0})
    report.per_agent.push_back({.length_m = 1, .time_s = time_s});
  EXPECT_DOUBLE_EQ(cv_time(report), std::sqrt(2 / 3.0) / 4);
}

}  // namespace
}  // namespace arcbid
