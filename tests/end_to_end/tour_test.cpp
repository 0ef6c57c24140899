// SPDX-License-Identifier: GPL-3.0-or-later
// `arcbid tour` as a user starts it.
#include <gmock/gmock.h>

#include <cmath>

#include "tests/end_to_end/launched.hpp"

namespace arcbid::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

constexpr const char* square =
    "NAME: square\nTYPE: TSP\nDIMENSION: 4\nEDGE_WEIGHT_TYPE: EUC_2D\nNODE_COORD_SECTION\n"
    "1 0 0\n2 10 0\n3 10 10\n4 0 10\nEOF\n";

class TourCommandTest : public ::testing::Test {
 protected:
  void run(const std::string& tsp, const std::string& pairs,
           std::vector<std::string> options = {}) {
    const auto a = scratch.file("square.tsp", tsp), b = scratch.file("square.pairs", pairs);
    std::vector<std::string> arguments{"tour", a, "--pairs", b, "--deadline-ms", "5"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    Launched arcbid(arguments);
    code = arcbid.wait_for_end(30);
    output = arcbid.output();
  }
  const Scratch scratch;
  std::optional<int> code;
  std::string output;
};

TEST_F(TourCommandTest, PrintsTheTourAsJson) {
  for (const std::string solver : {"crsom", "crsom+ls", "ga", "aco", "pso"}) {
    run(square, "1 2\n3 4\n", {"--solver", solver, "--json", "-"});
    ASSERT_EQ(code, 0) << output;
    const json answer = json::parse(output);
    EXPECT_NEAR(answer.at("length"), 40, 1e-9) << solver;
    EXPECT_NEAR(answer.at("connecting"), 20, 1e-9);
    EXPECT_GE(answer.at("seconds"), 0);
    EXPECT_EQ(answer.at("order").size(), 4u);
  }
}

TEST_F(TourCommandTest, RefusesBadInputInOneLineThatSaysWhere) {
  const std::vector<std::array<std::string, 3>> cases{
      {"NAME: x\nEOF\n", "1 2\n", "square.tsp: no NODE_COORD_SECTION"},
      {"NODE_COORD_SECTION\n1 0 zero\nEOF\n", "1 2\n", "square.tsp:2: 'zero' is no coordinate"},
      {square, "1 2\n3 9\n", "square.pairs:2: there is no city 9; legal: 1 to 4"},
      {square, "1 2\n", "square.pairs: city 3 is in no pair"},
      {square, "1 2\n2 3\n", "square.pairs:2: city 2 is in a pair already"}};
  for (const auto& [tsp, pairs, message] : cases) {
    run(tsp, pairs);
    EXPECT_EQ(code, 2) << output;
    EXPECT_THAT(output, HasSubstr(message));
    EXPECT_EQ(std::ranges::count(output, '\n'), 1) << output;
  }
}

TEST_F(TourCommandTest, RefusesUnknownSolversAndFilesThatAreNotThere) {
  run(square, "1 2\n3 4\n", {"--solver", "lkh"});
  EXPECT_EQ(code, 2);
  EXPECT_THAT(output, HasSubstr("crsom+ls"));
  Launched arcbid({"tour", scratch / "none.tsp", "--pairs", scratch / "none.pairs"});
  EXPECT_EQ(arcbid.wait_for_end(30), 2);
  EXPECT_THAT(arcbid.output(), HasSubstr("none.tsp"));
}

}  // namespace
}  // namespace arcbid::testing
