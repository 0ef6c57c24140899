// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's numbers, against another copy of them.
#include "sim/reproduce/paper.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace arcbid::reproduce::paper {
namespace {

std::filesystem::path spec(const char* name) {
  return std::filesystem::path(ARCBID_SHARED_DATA).parent_path() / "spec" / name;
}

/// The numbers of a Markdown table's row that begins with `head`; empty without such a row.
std::vector<double> row(const std::filesystem::path& file, const std::string& head) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with("| " + head + " |")) continue;
    std::istringstream fields(line.substr(head.size() + 4));
    std::vector<double> numbers;
    for (std::string field; std::getline(fields, field, '|');) {
      std::istringstream text(field);
      if (double value = 0; text >> value) numbers.push_back(value);
    }
    return numbers;
  }
  return {};
}

TEST(Paper, Table1IsThatOfTheSpec) {
  if (!std::filesystem::exists(spec("bridge.md"))) GTEST_SKIP() << "no spec/bridge.md";
  for (const Modelling& m : kModelling)
    EXPECT_EQ(row(spec("bridge.md"), std::to_string(static_cast<int>(m.spacing_m))),
              (std::vector<double>{m.arcs_s, static_cast<double>(m.arcs), kCoveragePercent,
                                   m.units_s, static_cast<double>(m.viewpoints), kCoveragePercent}))
        << m.spacing_m;
}

TEST(Paper, Table2IsThatOfTheSpec) {
  if (!std::filesystem::exists(spec("tour.md"))) GTEST_SKIP() << "no spec/tour.md";
  for (const TourSet& set : kTourSets) {
    std::vector<double> ours;
    for (const Solved& solved : {set.crsom, set.ga, set.aco, set.pso}) {
      ours.push_back(solved.seconds);
      ours.push_back(solved.gap);
    }
    EXPECT_EQ(row(spec("tour.md"), std::string(set.name)), ours) << set.name;
    EXPECT_TRUE(set.name.ends_with(std::to_string(set.cities))) << set.name;
  }
}

}  // namespace
}  // namespace arcbid::reproduce::paper
